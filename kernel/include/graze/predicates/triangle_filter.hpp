// Ray and triangle in working precision, with proven error bounds. With E1 = b - a, E2 = c - a, T = e - a, H = d x E2 and G = T x E1:
//   determinant = E1.H = -d.n,   u = T.H / determinant,   v = d.G / determinant,   t = E2.G / determinant
// (Moeller & Trumbore 1997). Corners enter as differences, so small triangles far from the origin lose nothing.
#pragma once

#include "graze/numeric/filter.hpp"

namespace graze::predicates {

/// The four determinants and bounds of their errors.
///
/// Each is a sum of six monomials xyz in components of three vectors, in magnitude at most their norms' product m. A monomial is
/// rounded at most 7 times: two differences, two products, one subtraction, two sums. So the error is at most
/// 6 m ((1 + unit)^7 - 1) < 42.001 unit m. The norms themselves are of rounded differences, and m of two rounded products:
/// 44 covers all that and underflow (see numeric/filter.hpp).
struct TriangleTerms {
  double determinant, u, v, distance;
  double determinant_error, u_error, v_error, distance_error;
  /// Whether the bounds hold: no vector too long or too short.
  bool are_bounded;
};

inline constexpr double triangle_error = 44 * numeric::unit;

template <Real T>
[[nodiscard]] inline TriangleTerms triangle_terms(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using namespace numeric;
  const Vector a = vector(triangle.a), d = vector(ray.direction);
  const Vector e1 = vector(triangle.b) - a, e2 = vector(triangle.c) - a, t = vector(ray.origin) - a;
  const Vector h = cross(d, e2), g = cross(t, e1);
  const double nd = norm(d), n1 = norm(e1), n2 = norm(e2), nt = norm(t);
  TriangleTerms r;
  r.determinant = dot(e1, h);
  r.u = dot(t, h);
  r.v = dot(d, g);
  r.distance = dot(e2, g);
  const double k2 = triangle_error * n2, k1 = triangle_error * n1, dt = nd * nt;
  r.determinant_error = k2 * (nd * n1);
  r.u_error = k2 * dt;
  r.v_error = k1 * dt;
  r.distance_error = k2 * (nt * n1);
  r.are_bounded = is_ordinary<T>(min(min(nd, nt), min(n1, n2)), max(max(nd, nt), max(n1, n2)));
  return r;
}

/// What the filter can tell. A verdict other than `uncertain` also vouches that the input is valid: a NaN or an infinity anywhere
/// leaves a term NaN or a norm out of range.
enum class TriangleVerdict { miss, face, uncertain };

/// The ray's range must be the default one or ordinary.
template <Real T>
[[nodiscard]] inline TriangleVerdict verdict(const TriangleTerms& terms, const Ray<T>& ray) noexcept {
  using namespace numeric;
  const double sign = __builtin_copysign(1.0, terms.determinant);
  const double whole = terms.determinant * sign, u = terms.u * sign, v = terms.v * sign, distance = terms.distance * sign;
  if (!(terms.are_bounded & (whole > terms.determinant_error))) return TriangleVerdict::uncertain;
  // The two subtractions err by at most 2 unit (whole + |u| + |v|), less than a tenth of the bounds' sum.
  const double w = whole - u - v;
  const double w_error = 1.25 * (terms.determinant_error + terms.u_error + terms.v_error);
  // One branch, for a random ray's signs cannot be predicted one by one.
  if ((u < -terms.u_error) | (v < -terms.v_error) | (w < -w_error)) return TriangleVerdict::miss;

  bool is_after = distance > terms.distance_error, is_before = distance < -terms.distance_error;
  if (!is_default_range(ray)) {
    // t > x where distance - x whole > 0: the product and the difference err by less than a tenth of the bounds' sum.
    const auto compare = [&](double x, bool& above, bool& below) {
      const double f = distance - x * whole;
      const double error = 1.25 * (terms.distance_error + magnitude(x) * terms.determinant_error);
      above = f > error;
      below = f < -error;
    };
    compare(static_cast<double>(ray.t_min), is_after, is_before);
    if (is_finite(ray.t_max)) {
      bool above, below;
      compare(static_cast<double>(ray.t_max), above, below);
      is_after = is_after && below;
      is_before = is_before || above;
    }
  }
  if (is_before) return TriangleVerdict::miss;
  const bool is_inside = (u > terms.u_error) & (v > terms.v_error) & (w > w_error);
  return (is_inside & is_after) ? TriangleVerdict::face : TriangleVerdict::uncertain;
}

}  // namespace graze::predicates
