// Ray and triangle in working precision, with proven error bounds. With E1 = b - a, E2 = c - a, T = e - a, H = d x E2 and G = T
// x E1:
//   determinant = E1.H = -d.n,   u = T.H / determinant,   v = d.G / determinant,   t = E2.G / determinant
// (Moeller & Trumbore 1997). Corners enter as differences, so small triangles far from the origin lose nothing.
#pragma once

#include "graze/numeric/filter.hpp"
#include "graze/numeric/two_lanes.hpp"

namespace graze::predicates {

/// The four determinants, all with the sign of `determinant` taken out, and bounds of their errors.
///
/// Each is a sum of six monomials xyz in components of three vectors, together at most m, the product of their sums of
/// magnitudes |.|. A monomial is rounded at most 7 times: two differences, two products, one subtraction, two sums. So the
/// error is at most ((1 + unit)^7 - 1) m < 7.001 unit m, and w = whole - u - v, rounded twice more, errs by less than 9.02 unit
/// of the three m together. With s = |E1| + |E2| and r = |T| + s that is 9.02 unit |d| (|E1||E2| + |T| s) < 9.02 unit |d| s r,
/// which bounds each of the four; the distance, of three differences, errs by 8.01 unit |T||E1||E2| < 8.01 unit s s r. 10 unit
/// covers the rounding of the bounds themselves (13 unit) and underflow (kernel/proofs/triangle_filter.g). A NaN or an infinity
/// in a vector makes a sum not ordinary.
template <class W>
struct TriangleTerms {
  W whole, u, v, w, distance;
  W error;           ///< of whole, u, v and w
  W distance_error;  ///< of the distance
  bool is_front;     ///< d.n < 0
  bool are_bounded;  ///< whether the bounds hold: no vector too long or too short
};

inline constexpr int triangle_error = 10;

/// W is the precision that is computed in, at least T's.
template <class W, Real T>
[[nodiscard]] inline TriangleTerms<W> triangle_terms(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using namespace numeric;
  using Two = TwoLanes<W>;
  const auto& [e, d, t_min, t_max] = ray;
  const auto& [a, b, c] = triangle;
  const Two ax = both(W(a.x)), ay = both(W(a.y)), az = both(W(a.z));
  // T and d in two lanes, E1 and E2 in two.
  const Two px = subtract_first(two_lanes(W(e.x), W(d.x)), ax), qx = two_lanes(W(b.x), W(c.x)) - ax;
  const Two py = subtract_first(two_lanes(W(e.y), W(d.y)), ay), qy = two_lanes(W(b.y), W(c.y)) - ay;
  const Two pz = subtract_first(two_lanes(W(e.z), W(d.z)), az), qz = two_lanes(W(b.z), W(c.z)) - az;
  // H and G.
  const Two x = swapped(multiply_add(py, qz, -(pz * qy)));
  const Two y = swapped(multiply_add(pz, qx, -(px * qz)));
  const Two z = swapped(multiply_add(px, qy, -(py * qx)));
  const Two signed_whole_distance = multiply_add(qx, x, multiply_add(qy, y, qz * z));
  const Two signed_u_v = multiply_add(px, x, multiply_add(py, y, pz * z));
  const auto sign = first_sign_in_both<W>(signed_whole_distance);
  const Two whole_distance = flipped<W>(signed_whole_distance, sign), u_v = flipped<W>(signed_u_v, sign);

  const Two p = magnitudes_of<W>(px) + magnitudes_of<W>(py) + magnitudes_of<W>(pz);
  const Two q = magnitudes_of<W>(qx) + magnitudes_of<W>(qy) + magnitudes_of<W>(qz);
  const W along = p[1], s = q[0] + q[1], r = p[0] + s, scale = triangle_error * unit_of<W> * (s * r);
  // A sum, not a maximum, against `high`: it is NaN where one of them is.
  return {whole_distance[0], u_v[0],    u_v[1],       whole_distance[0] - u_v[0] - u_v[1],        whole_distance[1],
          scale * along,     scale * s, sign[0] == 0, is_ordinary<W, T>(min(s, along), along + r)};
}

/// What the filter can tell. A verdict other than `uncertain` also vouches that the input is valid, but for the range where it
/// is `miss`.
enum class TriangleVerdict { miss, face, uncertain };

/// Where the distance lies against a bound x of the range: t > x where distance - x whole > 0. Both terms err by 9.02 unit
/// at most, the product and the difference included, so their bounds hold for f too.
struct BoundTest {
  bool above, below;
};

template <class W>
[[nodiscard]] inline BoundTest test_bound(W x, const TriangleTerms<W>& terms) noexcept {
  const W f = terms.distance - x * terms.whole;
  const W error = terms.distance_error + numeric::magnitude(x) * terms.error;
  return {f > error, f < -error};
}

/// Whether t lies inside the range, or outside. Of a range whose bounds are not ordinary nothing is told.
struct RangeTest {
  bool inside, outside;
};

template <class W, Real T>
[[nodiscard]] inline RangeTest test_range(const TriangleTerms<W>& terms, const Ray<T>& ray) noexcept {
  if (numeric::is_default_range(ray)) return {terms.distance > terms.distance_error, terms.distance < -terms.distance_error};
  if (!numeric::is_ordinary_range<W>(ray)) return {false, false};
  const BoundTest from = test_bound(static_cast<W>(ray.t_min), terms);
  if (!numeric::is_finite(ray.t_max)) return {from.above, from.below};
  const BoundTest to = test_bound(static_cast<W>(ray.t_max), terms);
  return {from.above && to.below, from.below || to.above};
}

template <class W, Real T>
[[nodiscard]] inline TriangleVerdict verdict(const TriangleTerms<W>& terms, const Ray<T>& ray) noexcept {
  const W least = numeric::min(numeric::min(terms.u, terms.v), terms.w);
  if (!(terms.are_bounded & (terms.whole > terms.error))) return TriangleVerdict::uncertain;
  // One branch: a random ray's signs, tested one by one, are mispredicted, which costs more than they save.
  if (least < -terms.error) return TriangleVerdict::miss;

  const RangeTest range = test_range(terms, ray);
  if (range.outside) return TriangleVerdict::miss;
  return ((least > terms.error) & range.inside) ? TriangleVerdict::face : TriangleVerdict::uncertain;
}

}  // namespace graze::predicates
