// Ray and triangle in working precision, with proven error bounds. With E1 = b - a, E2 = c - a, T = e - a, H = d x E2 and G = T
// x E1:
//   determinant = E1.H = -d.n,   u = T.H / determinant,   v = d.G / determinant,   t = E2.G / determinant
// (Moeller & Trumbore 1997). Corners enter as differences, so small triangles far from the origin lose nothing.
#pragma once

#include "graze/numeric/filter.hpp"

namespace graze::predicates {

/// The four determinants and bounds of their errors.
///
/// Each is a sum of six monomials xyz in components of three vectors, together at most m, the product of their sums of
/// magnitudes. A monomial is rounded at most 7 times: two differences, two products, one subtraction, two sums. So the error is
/// at most
/// ((1 + unit)^7 - 1) m < 7.001 unit m. The vectors in m are rounded differences, m itself is rounded 8 times: 8 unit m covers
/// that, and underflow (see numeric/filter.hpp). A NaN or an infinity in a vector makes its sum not ordinary.
struct TriangleTerms {
  double determinant, u, v, distance;
  double determinant_error, u_error, v_error, distance_error;
  /// Whether the bounds hold: no vector too long or too short.
  bool are_bounded;
};

inline constexpr double triangle_error = 8 * numeric::unit;

template <Real T>
[[nodiscard]] inline TriangleTerms triangle_terms(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using namespace numeric;
  const Vector a = vector(triangle.a), d = vector(ray.direction);
  const Vector e1 = vector(triangle.b) - a, e2 = vector(triangle.c) - a, from_a = vector(ray.origin) - a;
  const Vector h = cross(d, e2), g = cross(from_a, e1);
  const double nd = magnitude_sum(d), n1 = magnitude_sum(e1), n2 = magnitude_sum(e2), nt = magnitude_sum(from_a);
  const double k2 = triangle_error * n2, k1 = triangle_error * n1, dt = nd * nt;
  // A sum, not a maximum, against `high`: it is NaN where one of them is.
  return {dot(e1, h), dot(from_a, h), dot(d, g),
          dot(e2, g), k2 * (nd * n1), k2 * dt,
          k1 * dt,    k2 * (nt * n1), is_ordinary<T>(min(min(nd, nt), min(n1, n2)), nd + nt + n1 + n2)};
}

/// What the filter can tell. A verdict other than `uncertain` also vouches that the input is valid, but for its range.
enum class TriangleVerdict { miss, face, uncertain };

/// Where the distance lies against a bound x of the range: t > x where distance - x whole > 0. The product and the difference
/// err by less than a quarter of the bounds' sum.
struct BoundTest {
  bool above, below;
};

[[nodiscard]] inline BoundTest test_bound(double x, double whole, double distance, const TriangleTerms& terms) noexcept {
  const double f = distance - x * whole;
  const double error = 1.25 * (terms.distance_error + numeric::magnitude(x) * terms.determinant_error);
  return {f > error, f < -error};
}

/// The ray's range must be the default one or ordinary.
template <Real T>
[[nodiscard]] inline TriangleVerdict verdict(const TriangleTerms& terms, const Ray<T>& ray) noexcept {
  const double sign = __builtin_copysign(1.0, terms.determinant);
  const double whole = terms.determinant * sign, u = terms.u * sign, v = terms.v * sign, distance = terms.distance * sign;
  if (!(terms.are_bounded & (whole > terms.determinant_error))) return TriangleVerdict::uncertain;

  // The subtractions err by at most 2 unit (whole + |u| + |v|), less than a quarter of the bounds' sum.
  const double w = whole - u - v, w_error = 1.25 * (terms.determinant_error + terms.u_error + terms.v_error);
  // One branch: a random ray's signs, tested one by one, are mispredicted, which costs more than they save.
  if ((u < -terms.u_error) | (v < -terms.v_error) | (w < -w_error)) return TriangleVerdict::miss;

  BoundTest from{distance > terms.distance_error, distance < -terms.distance_error};
  if (!numeric::is_default_range(ray)) {
    from = test_bound(static_cast<double>(ray.t_min), whole, distance, terms);
    if (numeric::is_finite(ray.t_max)) {
      const BoundTest to = test_bound(static_cast<double>(ray.t_max), whole, distance, terms);
      from = {from.above && to.below, from.below || to.above};
    }
  }
  if (from.below) return TriangleVerdict::miss;
  const bool is_inside = (u > terms.u_error) & (v > terms.v_error) & (w > w_error);
  return (is_inside & from.above) ? TriangleVerdict::face : TriangleVerdict::uncertain;
}

}  // namespace graze::predicates
