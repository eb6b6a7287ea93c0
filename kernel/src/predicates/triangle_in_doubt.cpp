// Decisions on triangles that a filter leaves in doubt: by integers of 64 and 128 bits where the input lies on a lattice of few
// steps, in every rounding mode; else by longer ones.
#include "graze/triangle.hpp"
#include "predicates/in_doubt.hpp"

namespace graze::predicates {
namespace {

#if GRAZE_HAS_SHORT_INTEGERS
/// Where the line meets the triangle: at no point, or at t >= 0 or t < 0.
enum class Meeting { none, ahead, behind, unknown };

/// The sums of magnitudes of E1, E2 and T together, and of d, are below 2^31 steps: components of cross products below 2^62,
/// determinants below 2^93.
template <Real T>
Meeting meeting(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using numeric::magnitude_sum, numeric::vector;
  const Vector<double> e = vector<double>(ray.origin), d = vector<double>(ray.direction);
  const Vector<double> a = vector<double>(triangle.a), b = vector<double>(triangle.b), c = vector<double>(triangle.c);
  const Vector<double> e1 = b - a, e2 = c - a, t = e - a;
  const double length = magnitude_sum(d), size = magnitude_sum(e1) + magnitude_sum(e2) + magnitude_sum(t);
  if (!Lattice::is_possible(length) || !Lattice::is_possible(size)) return Meeting::unknown;
  Lattice directions(length), positions(size);
  directions.include(d);
  if (!directions.holds_all()) return Meeting::unknown;
  positions.include(e), positions.include(a), positions.include(b), positions.include(c);
  if (!positions.holds_all()) return Meeting::unknown;
  const ShortVec3 along = short_vec3(directions, d), from_a = short_vec3(positions, t);
  const ShortVec3 first = short_vec3(positions, e1), second = short_vec3(positions, e2);
  const ShortVec3 h = cross(along, second), g = cross(from_a, first);
  Wide whole = wide_dot(first, h), u = wide_dot(from_a, h), v = wide_dot(along, g), distance = wide_dot(second, g);
  // Parallel to the plane, or without one.
  if (whole == 0) return distance == 0 ? Meeting::unknown : Meeting::none;
  if (whole < 0) whole = -whole, u = -u, v = -v, distance = -distance;
  if (u < 0 || v < 0 || whole - u - v < 0) return Meeting::none;
  return distance < 0 ? Meeting::behind : Meeting::ahead;
}
#endif

}  // namespace

template <Real T>
bool hits_in_doubt(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
#if GRAZE_HAS_SHORT_INTEGERS
  if (!is_hidden(ray, triangle)) {
    const Meeting met = meeting(ray, triangle);
    if (met == Meeting::none) return false;
    if (met != Meeting::unknown) {
      if (numeric::is_default_range(ray)) return met == Meeting::ahead;
      // The filter's words on the range stand where it knows the determinant's sign.
      const TriangleTerms<double> terms = triangle_terms<double>(ray, triangle);
      const RangeTest range = test_range(terms, ray);
      if (terms.are_bounded && terms.whole > terms.error && (range.inside || range.outside)) return range.inside;
    }
  }
#endif
  return exact::hits(ray, triangle);
}

template bool hits_in_doubt(const Ray<float>&, const Triangle<float>&) noexcept;
template bool hits_in_doubt(const Ray<double>&, const Triangle<double>&) noexcept;

bool hits_in_double(const Ray<float>& ray, const Triangle<float>& triangle) noexcept {
  const TriangleTerms<double> terms = triangle_terms<double>(ray, triangle);
  const TriangleVerdict answer = verdict(terms, ray);
  return answer == TriangleVerdict::uncertain ? hits_in_doubt(ray, triangle) : answer == TriangleVerdict::face;
}

}  // namespace graze::predicates
