// The roots that the filter has found, rounded from double-double (double) or double (float).
#include "graze/sphere.hpp"
#include "numeric/double_double.hpp"
#include "rounding/candidate.hpp"

namespace graze::rounding {
namespace {

using numeric::Lanes;
using numeric::Pair;
using numeric::PairLanes;
using predicates::SphereTerms;
using predicates::SphereVerdict;

/// A, B, C, D and what bounds the errors that come of them: `steps` of the root for A's and all steps' own, of sqrt(A c_size)
/// for B's.
struct Coefficients {
  Pair a, b, c, discriminant;
  double steps, c_error, discriminant_error;
};

/// As they stand.
Coefficients coefficients(const Ray<float>&, const Sphere<float>&, const SphereTerms<double>& t) noexcept {
  return {{t.a, 0}, {t.b, 0}, {t.c, 0}, {t.discriminant, 0}, double_steps, t.c_error, t.discriminant_error};
}

/// In double-double, L exact.
Coefficients coefficients(const Ray<double>& ray, const Sphere<double>& sphere, const SphereTerms<double>& t) noexcept {
  using namespace numeric;
  const Lanes d = lanes(ray.direction);
  // C = L.L - r^2 as one sum of four products.
  PairLanes l = two_difference(lanes(sphere.center, sphere.radius), lanes(ray.origin)), m = l;
  m.hi[3] = -m.hi[3];
  const PairLanes n = sums(two_product(d, d), d * l, l * m, PairLanes{});
  const Pair a{n.hi[0], n.lo[0]}, b{n.hi[1], n.lo[1]}, c{n.hi[2], n.lo[2]};
  const Pair discriminant = normalised(b * b - a * c);
  return {a, b, normalised(c), discriminant, pair_steps, pair_c_error * t.c_size, pair_discriminant_error * t.a * t.c_size};
}

/// n / d by d's rounded reciprocal. C must be normalised, A is to 3 * 2^-53 of itself. B's low part, and so q's, may be 2^-51
/// sqrt(A c_size); as q >= sqrt(D), what that costs is paid for with the errors that B's and D's give.
Pair divide(const Pair& n, const Pair& d, double reciprocal) noexcept {
  const double q = n.hi * reciprocal;
  const Pair p = numeric::two_product(q, d.hi);
  return {q, (((n.hi - p.hi) - p.lo) + (n.lo - q * d.lo)) * reciprocal};
}

}  // namespace

/// With q = B + sgn+(B) sqrt(D), sgn+(0) = 1: q / A is the root farther from zero, C / q the nearer; nothing cancels.
template <Real T>
SphereHit<T> roots(const Ray<T>& ray, const Sphere<T>& sphere, const SphereTerms<double>& terms,
                   const SphereVerdict& verdict) noexcept {
  using numeric::magnitude;
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, sphere);
  const Coefficients k = coefficients(ray, sphere, terms);
  if (!(k.discriminant.hi > certainty * k.discriminant_error)) return exact::intersect(ray, sphere);
  const double s = __builtin_sqrt(k.discriminant.hi), half_reciprocal = 0.5 / s;
  const Pair square = numeric::two_product(s, s);
  const Pair root{s, (((k.discriminant.hi - square.hi) - square.lo) + k.discriminant.lo) * half_reciprocal};
  const bool is_negative = k.b.hi < 0;
  const Pair q = is_negative ? k.b - root : k.b + root;
  const double q_reciprocal = 1 / q.hi, a_reciprocal = 1 / k.a.hi;
  // Relative to q, and with A's and the operations' own to the quotients.
  const double q_error =
      (k.steps * __builtin_sqrt(terms.a * terms.c_size) + (1 + root_share) * k.discriminant_error * half_reciprocal) *
          magnitude(q_reciprocal) +
      k.steps;
  const auto far = [&](T& out) {
    const Pair t = divide(q, k.a, a_reciprocal);
    return rounds_certainly(t.hi, t.lo, magnitude(t.hi) * q_error, out);
  };
  const auto near = [&](T& out) {
    const Pair t = divide(k.c, q, q_reciprocal);
    return rounds_certainly(t.hi, t.lo, magnitude(t.hi) * q_error + k.c_error * magnitude(q_reciprocal), out);
  };
  SphereHit<T> hit;
  int count = 0;
  bool is_certain = true;
  if (verdict.root != Root::second) is_certain = is_negative ? far(hit.t[count++]) : near(hit.t[count++]);
  if (verdict.root != Root::first) is_certain &= is_negative ? near(hit.t[count]) : far(hit.t[count]);
  if (!is_certain) return exact::intersect(ray, sphere);
  hit.kind = SphereKind::secant;
  hit.root = verdict.root;
  hit.origin = verdict.origin;
  return hit;
}

template SphereHit<float> roots(const Ray<float>&, const Sphere<float>&, const SphereTerms<double>&,
                                const SphereVerdict&) noexcept;
template SphereHit<double> roots(const Ray<double>&, const Sphere<double>&, const SphereTerms<double>&,
                                 const SphereVerdict&) noexcept;

}  // namespace graze::rounding
