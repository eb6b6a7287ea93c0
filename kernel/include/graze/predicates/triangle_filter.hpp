// Ray and triangle in working precision, with proven error bounds. With E1 = b - a, E2 = c - a, T = e - a, H = d x E2 and G = T x E1:
//   determinant = E1.H = -d.n,   u = T.H / determinant,   v = d.G / determinant,   t = E2.G / determinant
// (Moeller & Trumbore 1997). Corners enter as differences, so small triangles far from the origin lose nothing.
#pragma once

#include "graze/numeric/filter.hpp"
#include "graze/numeric/lanes.hpp"

namespace graze::predicates {

/// The four determinants and bounds of their errors.
///
/// Each is a sum of six monomials xyz in components of three vectors, together at most m, the product of their sums of magnitudes.
/// A monomial is rounded at most 7 times: two differences, two products, one subtraction, two sums. So the error is at most
/// ((1 + unit)^7 - 1) m < 7.001 unit m. The vectors in m are rounded differences, m itself is rounded 8 times: 8 unit m covers that,
/// and underflow (see numeric/filter.hpp). A NaN or an infinity in a vector makes its sum not ordinary.
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
  const Lanes a = lanes(triangle.a), d = lanes(ray.direction);
  const Lanes e1 = lanes(triangle.b) - a, e2 = lanes(triangle.c) - a, t = lanes(ray.origin) - a;
  const Lanes h = cross(d, e2), g = cross(t, e1);
  const Columns terms = transposed(e1 * h, t * h, d * g, e2 * g);
  const Lanes value = terms.first + terms.second + terms.third;
  const Columns sizes = transposed(magnitudes(e1), magnitudes(t), magnitudes(d), magnitudes(e2));
  const Lanes size = sizes.first + sizes.second + sizes.third;  // of e1, t, d, e2
  const Lanes error = triangle_error * __builtin_shufflevector(size, size, 0, 1, 1, 0) *
                      __builtin_shufflevector(size, size, 2, 2, 2, 1) * __builtin_shufflevector(size, size, 3, 3, 0, 3);
  return {value[0], value[1], value[2], value[3], error[0], error[1], error[2], error[3],
          is_ordinary<T>(min(min(size[0], size[1]), min(size[2], size[3])), max(max(size[0], size[1]), max(size[2], size[3])))};
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
