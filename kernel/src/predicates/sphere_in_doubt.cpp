// Decisions on spheres that a filter leaves in doubt: by integers of 64 and 128 bits where the input lies on a lattice of few
// steps, in every rounding mode; else by longer ones.
#include "graze/sphere.hpp"
#include "predicates/in_doubt.hpp"

namespace graze::predicates {
namespace {

#if GRAZE_HAS_SHORT_INTEGERS
/// Where the line meets the sphere: at no point, at one alone, or at two; and whether at some t >= 0.
struct Meeting {
  bool is_known, touches, crosses, is_ahead;
};

/// The sums of magnitudes of L and r together, and of d, are below 2^31 steps: A, B and C below 2^62, B^2 and A C below 2^124.
/// t2 = (B + sqrt(D)) / A >= 0 where B >= 0 or C <= 0.
template <Real T>
Meeting meeting(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using numeric::magnitude_sum, numeric::vector;
  const Vector<double> e = vector<double>(ray.origin), d = vector<double>(ray.direction);
  const Vector<double> c = vector<double>(sphere.center), l = c - e;
  const auto r = static_cast<double>(sphere.radius);
  const double length = magnitude_sum(d), size = magnitude_sum(l) + r;
  if (!Lattice::is_possible(length) || !Lattice::is_possible(size)) return {};
  Lattice directions(length), positions(size);
  directions.include(d);
  if (!directions.holds_all()) return {};
  positions.include(e), positions.include(c), positions.include(r);
  if (!positions.holds_all()) return {};
  const ShortVec3 along = short_vec3(directions, d), to_center = short_vec3(positions, l);
  const std::int64_t radius = positions.in_steps(r);
  const std::int64_t a = dot(along, along), b = dot(along, to_center), power = dot(to_center, to_center) - radius * radius;
  const Wide bb = wide_product(b, b), ac = wide_product(a, power);
  return {true, bb == ac, bb > ac, b >= 0 || power <= 0};
}
#endif

}  // namespace

template <Real T>
bool hits_in_doubt(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
#if GRAZE_HAS_SHORT_INTEGERS
  if (is_plain<double>(ray, sphere) && !is_hidden(ray, sphere)) {
    const Meeting met = meeting(ray, sphere);
    if (met.is_known) {
      if (!met.touches && !met.crosses) return false;
      if (numeric::is_default_range(ray)) return met.is_ahead;
      if (met.crosses) {
        // The filter's words on the range stand where there are two roots.
        const SphereTerms<double> terms = sphere_terms<double>(ray, sphere);
        const SphereVerdict answer = verdict_of_secant(terms, ray);
        if (terms.are_bounded && answer.kind != SphereKind::invalid) return answer.kind == SphereKind::secant;
      }
    }
  }
#endif
  return exact::hits(ray, sphere);
}

template bool hits_in_doubt(const Ray<float>&, const Sphere<float>&) noexcept;
template bool hits_in_doubt(const Ray<double>&, const Sphere<double>&) noexcept;

bool hits_in_double(const Ray<float>& ray, const Sphere<float>& sphere) noexcept {
  SphereTerms<double> terms = sphere_terms<double>(ray, sphere);
  const SphereKind answer = verdict(terms, ray, sphere).kind;
  return answer == SphereKind::invalid ? hits_in_doubt(ray, sphere) : answer == SphereKind::secant;
}

}  // namespace graze::predicates
