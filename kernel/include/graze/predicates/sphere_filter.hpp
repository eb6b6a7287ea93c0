// Ray and sphere in working precision, with proven error bounds. With L = c - e:
//   A = d.d,  B = d.L,  C = L.L - r^2,  D = B^2 - A C = A r^2 - |d x L|^2
// The first form of D is the cheaper; the second subtracts no two large squares where the sphere is far (Haines et al. 2019).
#pragma once

#include "graze/numeric/filter.hpp"

namespace graze::predicates {

/// The coefficients of A t^2 - 2 B t + C, the discriminant D, and bounds of the errors of C and D.
template <class W>
struct SphereTerms {
  W a, b, c, discriminant;
  W c_size;  ///< L.L + r^2: |C| <= c_size, and |B| <= sqrt(A c_size) by Cauchy and Schwarz
  W c_error, discriminant_error;
  bool are_bounded;  ///< whether the bounds hold: no vector too long or too short
};

// The errors in units as in numeric/filter.hpp, with S = A c_size (kernel/proofs/sphere_filter.g):
//  - A is rounded 3 times (a product, two sums); L.L twice more, in L; r^2 once; C once more: |C error| <= 6 unit c_size, 7
//  with slack;
//  - B: monomials d L of 4 roundings, so at most 4 unit |d||L| <= 4 unit sqrt(S);
//  - D: B^2 errs by 2 * 4 unit S + 1 unit S, A C by (3 + 6 + 1) unit S, the subtraction by 2 unit S: 21 unit S, 24 with slack.
inline constexpr int sphere_c_error = 7, sphere_discriminant_error = 24;

/// A and c_size in [low^2, high^2] keep every vector ordinary. A NaN or an infinity anywhere leaves A, c_size or D not
/// ordinary.
/// W is the precision that is computed in, at least T's.
template <class W, Real T>
[[nodiscard]] inline SphereTerms<W> sphere_terms(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using namespace numeric;
  constexpr W low = Ordinary<W, T>::low * Ordinary<W, T>::low, high = Ordinary<W, T>::high * Ordinary<W, T>::high;
  const Vector<W> d = vector<W>(ray.direction), l = vector<W>(sphere.center) - vector<W>(ray.origin);
  const auto r = static_cast<W>(sphere.radius);
  const W r2 = r * r, l2 = dot(l, l);
  SphereTerms<W> t;
  t.a = dot(d, d);
  t.b = dot(d, l);
  t.c = l2 - r2;
  t.c_size = l2 + r2;
  t.discriminant = t.b * t.b - t.a * t.c;
  t.c_error = sphere_c_error * unit_of<W> * t.c_size;
  t.are_bounded = (t.a >= low) & (t.a <= high) & (t.c_size >= low) & (t.c_size <= high);
  t.discriminant_error = sphere_discriminant_error * unit_of<W> * (t.a * t.c_size);
  return t;
}

// A component X of d x L has two monomials of 3 roundings, in magnitude at most |d||L| together: x = 3 unit sqrt(S), 4 with
// slack; |X|^2 errs by 2 x |X|_1 + 3 x^2 and by 3 unit in its squares and sums, A r^2 by 5 unit, the subtraction by 1: 7 unit
// with slack.
inline constexpr int sphere_perpendicular_error = 4, sphere_refined_error = 7;

/// The discriminant by the perpendicular, for what the first form leaves in doubt.
template <Real T>
inline void refine_discriminant(SphereTerms<double>& t, const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using namespace numeric;
  const Vector<double> x = cross(vector<double>(ray.direction), vector<double>(sphere.center) - vector<double>(ray.origin));
  const auto r = static_cast<double>(sphere.radius);
  const double x2 = dot(x, x), ar2 = t.a * (r * r), sum = magnitude(x.x) + magnitude(x.y) + magnitude(x.z);
  const double x_error = sphere_perpendicular_error * unit * __builtin_sqrt(t.a * t.c_size);
  t.discriminant = ar2 - x2;
  t.discriminant_error = sphere_refined_error * unit * (ar2 + x2) + x_error * (2 * sum + 3 * x_error);
}

/// Where a number x lies against the roots t1 < t2.
enum class Place { before, between, after, uncertain };

// With b = sqrt(A c_size) >= |B|, B errs by 4 unit b, A by 3 unit, C by 6 unit c_size. In f, A's term is rounded 4 times more,
// B's 3 times, C's once: 7 unit of the sum of magnitudes, 8 with slack; g errs less.
inline constexpr int sphere_place_error = 8;

/// By the signs of f = A x^2 - 2 B x + C and g = A x - B, for x = 0 or ordinary.
template <class W>
[[nodiscard]] inline Place place_of(W x, const SphereTerms<W>& t) noexcept {
  using numeric::magnitude;
  const W ax = t.a * x, f = (ax - 2 * t.b) * x + t.c, g = ax - t.b;
  const W size = magnitude(x), ax_size = t.a * size, b_size = numeric::square_root(t.a * t.c_size);
  const W g_error = sphere_place_error * numeric::unit_of<W> * (ax_size + b_size);
  const W f_error = sphere_place_error * numeric::unit_of<W> * ((ax_size + 2 * b_size) * size + t.c_size);
  if (f < -f_error) return Place::between;
  if (!(f > f_error)) return Place::uncertain;
  return g < -g_error ? Place::before : g > g_error ? Place::after : Place::uncertain;
}

/// What the filter can tell. A verdict other than `invalid`, which stands for uncertain, vouches that the input is valid, but
/// for the range and the radius's sign where it is `miss`.
struct SphereVerdict {
  SphereKind kind;  ///< miss, secant, or invalid
  Root root;
  OriginSide origin;
};

inline constexpr SphereVerdict uncertain_sphere{SphereKind::invalid, Root::none, OriginSide::outside};

[[nodiscard]] inline SphereVerdict verdict_of_roots(bool first, bool second, OriginSide origin) noexcept {
  if (!first && !second) return {SphereKind::miss, Root::none, origin};
  return {SphereKind::secant, first && second ? Root::both : first ? Root::first : Root::second, origin};
}

/// Whether range and radius are such that the filter's verdict may be trusted.
template <class W, Real T>
[[nodiscard]] inline bool is_plain(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  const bool has_sign = (numeric::bits_of(sphere.radius) & numeric::sign_bit<T>) != 0;
  return !has_sign && (numeric::is_default_range(ray) || numeric::is_ordinary_range<W>(ray));
}

/// The verdict where there are two roots.
template <class W, Real T>
[[nodiscard]] inline SphereVerdict verdict_of_secant(const SphereTerms<W>& t, const Ray<T>& ray) noexcept {
  using numeric::magnitude_bits;
  if (!(numeric::magnitude(t.c) > t.c_error)) return uncertain_sphere;
  // Where C > 0 it exceeds unit / 2 of c_size, so B^2 > A C > unit / 2 S: B is far from zero, and its computed sign right.
  const bool is_inside = t.c<0, is_ahead = t.b> 0;
  const OriginSide origin = is_inside ? OriginSide::inside : OriginSide::outside;
  if (numeric::is_default_range(ray)) return verdict_of_roots(!is_inside && is_ahead, is_inside || is_ahead, origin);
  const auto place = [&](T x) {
    if (magnitude_bits(x) != 0) return place_of(static_cast<W>(x), t);
    return is_inside ? Place::between : is_ahead ? Place::before : Place::after;
  };
  const Place from = place(ray.t_min), to = numeric::is_finite(ray.t_max) ? place(ray.t_max) : Place::after;
  if (from == Place::uncertain || to == Place::uncertain) return uncertain_sphere;
  return verdict_of_roots(from == Place::before && to != Place::before, from != Place::after && to == Place::after, origin);
}

/// In double, a discriminant in doubt is refined; in float that is left to the filter in double.
template <class W, Real T>
[[nodiscard]] inline SphereVerdict verdict(SphereTerms<W>& t, const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using numeric::magnitude;
  if (!(t.are_bounded & (magnitude(t.discriminant) > t.discriminant_error))) [[unlikely]] {
    if (sizeof(W) < sizeof(double) || !t.are_bounded) return uncertain_sphere;
    if constexpr (sizeof(W) == sizeof(double)) refine_discriminant(t, ray, sphere);
    if (!(magnitude(t.discriminant) > t.discriminant_error)) return uncertain_sphere;
  }
  // No root: A C > B^2, so the origin is outside.
  if (t.discriminant < 0) return {SphereKind::miss, Root::none, OriginSide::outside};
  return is_plain<W>(ray, sphere) ? verdict_of_secant(t, ray) : uncertain_sphere;
}

}  // namespace graze::predicates
