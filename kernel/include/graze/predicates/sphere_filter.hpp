// Ray and sphere in working precision, with proven error bounds. With L = c - e:
//   A = d.d,  B = d.L,  C = L.L - r^2,  D = A r^2 - |d x L|^2
// D in this form subtracts no two large squares where the sphere is far (Haines et al. 2019, by the perpendicular).
#pragma once

#include "graze/numeric/filter.hpp"

namespace graze::predicates {

/// The coefficients of A t^2 - 2 B t + C, the discriminant D, and bounds of the errors of B, C and D. With n the norm of d,
/// s = max(norm of L, r), unit as in numeric/filter.hpp:
///  - B: three monomials of at most 4 roundings (a difference, a product, two sums): 3 n s 4 unit, 13 with slack;
///  - C: L.L is rounded 5 times (two differences, a product, two sums) and r^2 once, then the subtraction: 6 unit (L.L + r^2), 7;
///  - a component X of d x L: two monomials of 3 roundings: x = 6 unit n s, 7 with slack;
///  - D: |X|^2 errs by 2 x |X|_1 + 3 x^2 and by 3 unit in its squares and sums, A r^2 by 5 unit, the subtraction by 1: 7 unit in all.
struct SphereTerms {
  double a, b, c, discriminant;
  double b_error, c_error, discriminant_error;
  double c_size;  ///< L.L + r^2
  double b_size;  ///< n s, of which |B| is at most three times
  /// Whether the bounds hold: no vector too long or too short.
  bool are_bounded;
};

template <Real T>
[[nodiscard]] inline SphereTerms sphere_terms(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using namespace numeric;
  const Vector d = vector(ray.direction), l = vector(sphere.center) - vector(ray.origin);
  const auto r = static_cast<double>(sphere.radius);
  const Vector x = cross(d, l);
  const double n = norm(d), s = max(norm(l), r), r2 = r * r, l2 = dot(l, l), x2 = dot(x, x);
  SphereTerms t;
  t.a = dot(d, d);
  t.b = dot(d, l);
  t.c = l2 - r2;
  const double ar2 = t.a * r2;
  t.discriminant = ar2 - x2;
  t.b_size = n * s;
  t.c_size = l2 + r2;
  t.b_error = 13 * unit * t.b_size;
  t.c_error = 7 * unit * t.c_size;
  const double x_error = 7 * unit * t.b_size;
  const double x_sum = magnitude(x.x) + magnitude(x.y) + magnitude(x.z);
  t.discriminant_error = 7 * unit * (ar2 + x2) + x_error * (2 * x_sum + 3 * x_error);
  t.are_bounded = is_ordinary<T>(min(n, s), max(n, s));
  return t;
}

/// Where a number x lies against the roots t1 < t2.
enum class Place { before, between, after, uncertain };

/// By the signs of f = A x^2 - 2 B x + C and g = A x - B. Each is rounded at most 6 times more, and A by 3 unit: 12 unit of the sum of
/// magnitudes and the errors of B and C. |x| is 0 or ordinary.
[[nodiscard]] inline Place place_of(double x, const SphereTerms& t) noexcept {
  using numeric::magnitude;
  const double ax = t.a * x, f = (ax - 2 * t.b) * x + t.c, g = ax - t.b, size = magnitude(x);
  const double ax_size = t.a * size;
  const double g_error = 12 * numeric::unit * (ax_size + 3 * t.b_size) + 2 * t.b_error;
  const double f_error = 12 * numeric::unit * ((ax_size + 6 * t.b_size) * size + t.c_size) + 2 * (t.c_error + 2 * t.b_error * size);
  if (f < -f_error) return Place::between;
  if (!(f > f_error)) return Place::uncertain;
  return g < -g_error ? Place::before : g > g_error ? Place::after : Place::uncertain;
}

/// What the filter can tell. As for triangles, a verdict other than `uncertain` vouches that all but the sign of the radius is valid.
struct SphereVerdict {
  SphereKind kind;  ///< miss or secant; invalid stands for uncertain
  Root root;
  OriginSide origin;
};

inline constexpr SphereVerdict uncertain_sphere{SphereKind::invalid, Root::none, OriginSide::outside};

[[nodiscard]] inline SphereVerdict verdict_of_roots(bool first, bool second, OriginSide origin) noexcept {
  if (!first && !second) return {SphereKind::miss, Root::none, origin};
  return {SphereKind::secant, first && second ? Root::both : first ? Root::first : Root::second, origin};
}

/// The ray's range must be the default one or ordinary.
template <Real T>
[[nodiscard]] inline SphereVerdict verdict(const SphereTerms& t, const Ray<T>& ray) noexcept {
  using numeric::magnitude_bits;
  if (!t.are_bounded) return uncertain_sphere;
  // No root: A C > B^2, so the origin is outside.
  if (t.discriminant < -t.discriminant_error) return {SphereKind::miss, Root::none, OriginSide::outside};
  if (!(t.discriminant > t.discriminant_error)) return uncertain_sphere;
  const Place zero = t.c < -t.c_error  ? Place::between
                     : !(t.c > t.c_error) ? Place::uncertain
                     : t.b > t.b_error    ? Place::before
                     : t.b < -t.b_error   ? Place::after
                                          : Place::uncertain;
  if (zero == Place::uncertain) return uncertain_sphere;
  const OriginSide origin = zero == Place::between ? OriginSide::inside : OriginSide::outside;
  if (numeric::is_default_range(ray)) return verdict_of_roots(zero == Place::before, zero != Place::after, origin);
  const Place from = magnitude_bits(ray.t_min) == 0 ? zero : place_of(static_cast<double>(ray.t_min), t);
  const Place to = !numeric::is_finite(ray.t_max)        ? Place::after
                   : magnitude_bits(ray.t_max) == 0 ? zero
                                                         : place_of(static_cast<double>(ray.t_max), t);
  if (from == Place::uncertain || to == Place::uncertain) return uncertain_sphere;
  return verdict_of_roots(from == Place::before && to != Place::before, from != Place::after && to == Place::after, origin);
}

}  // namespace graze::predicates
