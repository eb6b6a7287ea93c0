// Intervals that hold a hit's exact first value, from what the filter has computed.
#pragma once

#include "exact/order.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::scene {

using exact::Enclosure;

/// t = distance / whole where the determinant's sign is certain: each side by the numbers' own bounds, which decide it, and
/// 2^-50 of itself for the three roundings. Nothing here is near overflow or underflow (numeric/filter.hpp).
[[nodiscard]] inline Enclosure enclose(double distance, double whole, double distance_error, double whole_error) noexcept {
  const double least = distance - distance_error, most = distance + distance_error;
  const double smaller = whole - whole_error, larger = whole + whole_error;
  constexpr double up = 1 + 0x1p-50, down = 1 - 0x1p-50;
  const double low = least / (least < 0 ? smaller : larger), high = most / (most < 0 ? larger : smaller);
  return {low * (least < 0 ? up : down), high * (most < 0 ? down : up)};
}
[[nodiscard]] inline Enclosure enclose(const predicates::TriangleTerms<double>& terms) noexcept {
  return enclose(terms.distance, terms.whole, terms.distance_error, terms.error);
}

/// The first root in the range of a secant that the filter is sure of, by q = B + sgn+(B) sqrt(D): q / A is the root farther
/// from zero, C / q the nearer. Errors as in sphere_filter.hpp: B by 4 unit sqrt(S), A by 3 unit, and sqrt(D) by at most
/// D_error / sqrt(D), as |sqrt(x) - sqrt(y)| <= |x - y| / sqrt(x). Where q or sqrt(D) is not known to a half, by exact
/// integers.
template <Real T>
[[nodiscard]] inline Enclosure enclose(const Ray<T>& ray, const Sphere<T>& sphere, const predicates::SphereTerms<double>& terms,
                                       const predicates::SphereVerdict& verdict) noexcept {
  using numeric::magnitude, numeric::unit;
  const double root = __builtin_sqrt(terms.discriminant);
  const bool is_negative = terms.b < 0, is_first = verdict.root != Root::second;
  const double q = is_negative ? terms.b - root : terms.b + root, size = magnitude(q);
  const double q_error = 8 * unit * __builtin_sqrt(terms.a * terms.c_size) + 2 * terms.discriminant_error / root;
  if (!(terms.discriminant > 2 * terms.discriminant_error) || !(size > 2 * q_error)) return exact::enclose_first(ray, sphere);
  const double relative = 2 * q_error / size + 16 * unit;
  if (is_first == is_negative) {
    const double t = q / terms.a, error = magnitude(t) * relative;
    return {t - error, t + error};
  }
  const double t = terms.c / q, error = magnitude(t) * relative + 4 * terms.c_error / size;
  return {t - error, t + error};
}

}  // namespace graze::scene
