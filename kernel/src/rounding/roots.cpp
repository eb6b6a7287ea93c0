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

/// A, B, C, D and what bounds their errors: A is within relative_error, the others within their errors.
struct Coefficients {
  Pair a, b, c, discriminant;
  double relative_error, b_error, c_error, discriminant_error;
};

/// As they stand.
Coefficients coefficients(const Ray<float>&, const Sphere<float>&, const SphereTerms& t) noexcept {
  const double b_size = __builtin_sqrt(t.a * t.c_size);
  return {{t.a, 0}, {t.b, 0}, {t.c, 0}, {t.discriminant, 0}, 0x1p-49, 0x1p-49 * b_size, t.c_error, t.discriminant_error};
}

/// In double-double, L exact: A, B and C are sums of a few products, each step within 4 * 2^-106 of its terms, so 2^-100 of the sums of
/// magnitudes A, sqrt(A c_size), c_size is more than enough. D = B^2 - A C: B^2 <= A L.L, so every term is at most A c_size, and the errors
/// add to less than 8 * 2^-100 A c_size.
Coefficients coefficients(const Ray<double>& ray, const Sphere<double>& sphere, const SphereTerms& t) noexcept {
  using namespace numeric;
  const Lanes d = lanes(ray.direction);
  // C = L.L - r^2 as one sum of four products.
  PairLanes l = two_difference(lanes(sphere.center, sphere.radius), lanes(ray.origin)), m = l;
  m.hi[3] = -m.hi[3];
  const PairLanes n = normalised(sums(two_product(d, d), d * l, l * m, PairLanes{}));
  const Pair a{n.hi[0], n.lo[0]}, b{n.hi[1], n.lo[1]}, c{n.hi[2], n.lo[2]};
  return {a, b, c, normalised(b * b - a * c),
          0x1p-100, 0x1p-100 * __builtin_sqrt(t.a * t.c_size), 0x1p-100 * t.c_size, 0x1p-96 * t.a * t.c_size};
}

}  // namespace

/// With q = B + sgn+(B) sqrt(D), sgn+(0) = 1: q / A is the root farther from zero, C / q the nearer; nothing cancels.
template <Real T>
SphereHit<T> roots(const Ray<T>& ray, const Sphere<T>& sphere, const SphereTerms& terms, const SphereVerdict& verdict) noexcept {
  using numeric::magnitude;
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, sphere);
  const Coefficients k = coefficients(ray, sphere, terms);
  // With D known to 2^-10 its root is known to first order, up to 2^-10 of that.
  if (!(k.discriminant.hi > 0x1p10 * k.discriminant_error)) return exact::intersect(ray, sphere);
  const Pair s = square_root(k.discriminant);
  const bool is_negative = k.b.hi < 0;
  const Pair q = normalised(is_negative ? k.b - s : k.b + s);
  const double q_size = magnitude(q.hi);
  const double s_error = 0.5078125 * k.discriminant_error / s.hi;
  // Relative errors: of q, and with A's or C's of the quotients; the operations themselves add at most relative_error each.
  const double q_error = (k.b_error + s_error) / q_size + 2 * k.relative_error;
  const auto far = [&](T& out) {
    const Pair t = q / k.a;
    return rounds_certainly(t.hi, t.lo, magnitude(t.hi) * (q_error + 2 * k.relative_error), out);
  };
  const auto near = [&](T& out) {
    const Pair t = k.c / q;
    return rounds_certainly(t.hi, t.lo, k.c_error / q_size + magnitude(t.hi) * (q_error + 2 * k.relative_error), out);
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

template SphereHit<float> roots(const Ray<float>&, const Sphere<float>&, const SphereTerms&, const SphereVerdict&) noexcept;
template SphereHit<double> roots(const Ray<double>&, const Sphere<double>&, const SphereTerms&, const SphereVerdict&) noexcept;

}  // namespace graze::rounding
