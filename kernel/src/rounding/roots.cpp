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

/// A, B, C, D and what bounds their errors: A is within `relative` of itself, B within relative * sqrt(A c_size).
struct Coefficients {
  Pair a, b, c, discriminant;
  double relative, c_error, discriminant_error;
};

/// As they stand.
Coefficients coefficients(const Ray<float>&, const Sphere<float>&, const SphereTerms<double>& t) noexcept {
  return {{t.a, 0}, {t.b, 0}, {t.c, 0}, {t.discriminant, 0}, 0x1p-49, t.c_error, t.discriminant_error};
}

/// In double-double, L exact: A, B and C are sums of a few products, each step within 4 * 2^-106 of its terms, so 2^-100 of the
/// sums of magnitudes A, sqrt(A c_size), c_size is more than enough. D = B^2 - A C: B^2 <= A L.L, so every term is at most A
/// c_size, and the errors add to less than 8 * 2^-100 A c_size.
Coefficients coefficients(const Ray<double>& ray, const Sphere<double>& sphere, const SphereTerms<double>& t) noexcept {
  using namespace numeric;
  const Lanes d = lanes(ray.direction);
  // C = L.L - r^2 as one sum of four products.
  PairLanes l = two_difference(lanes(sphere.center, sphere.radius), lanes(ray.origin)), m = l;
  m.hi[3] = -m.hi[3];
  const PairLanes n = sums(two_product(d, d), d * l, l * m, PairLanes{});
  const Pair a{n.hi[0], n.lo[0]}, b{n.hi[1], n.lo[1]}, c{n.hi[2], n.lo[2]};
  return {a, b, normalised(c), normalised(b * b - a * c), 0x1p-100, 0x1p-100 * t.c_size, 0x1p-96 * t.a * t.c_size};
}

/// n / d by d's rounded reciprocal. Where the low parts of n and d are x and y of the high ones, this errs by x y and y^2, and
/// a few 2^-53 (x + y): A and C are normalised (y, x <= 2^-52). B's low part, and so q's, may be 2^-51 sqrt(A c_size); as q >=
/// sqrt(D), both 2^-52 y and y^2 <= 2^-102 A c_size / q sqrt(D) are below the errors of q that B's and D's give.
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
  // With D known to 2^-10 its root is known to first order, up to 2^-10 of that.
  if (!(k.discriminant.hi > 0x1p10 * k.discriminant_error)) return exact::intersect(ray, sphere);
  const double s = __builtin_sqrt(k.discriminant.hi), half_reciprocal = 0.5 / s;
  const Pair square = numeric::two_product(s, s);
  const Pair root{s, (((k.discriminant.hi - square.hi) - square.lo) + k.discriminant.lo) * half_reciprocal};
  const bool is_negative = k.b.hi < 0;
  const Pair q = is_negative ? k.b - root : k.b + root;
  const double q_reciprocal = 1 / q.hi, a_reciprocal = 1 / k.a.hi;
  // Relative errors of q, and with A's and the operations' own of the quotients.
  const double q_error =
      (k.relative * __builtin_sqrt(terms.a * terms.c_size) + 1.0078125 * k.discriminant_error * half_reciprocal) *
          magnitude(q_reciprocal) * (1 + 0x1p-20) +
      4 * k.relative;
  const auto far = [&](T& out) {
    const Pair t = divide(q, k.a, a_reciprocal);
    return rounds_certainly(t.hi, t.lo, magnitude(t.hi) * q_error, out);
  };
  const auto near = [&](T& out) {
    const Pair t = divide(k.c, q, q_reciprocal);
    return rounds_certainly(t.hi, t.lo, magnitude(t.hi) * q_error + k.c_error * magnitude(q_reciprocal) * (1 + 0x1p-20), out);
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
