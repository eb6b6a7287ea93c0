// Ray and triangle in one plane, and ray and degenerate triangle: the common part of a line and a convex flat set.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "exact/quotient.hpp"
#include "exact/scaled.hpp"

namespace graze::exact {

/// The parameters at which the line enters and leaves; first <= last.
template <int N>
using LineInterval = std::optional<std::pair<Quotient<N>, Quotient<N>>>;

template <int N>
[[nodiscard]] inline const Integer<N>& component(const IntegerVec3<N>& v, int axis) noexcept {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// An axis along which v is not zero; v is not the zero vector.
template <int N>
[[nodiscard]] inline int nonzero_axis(const IntegerVec3<N>& v) noexcept {
  return !v.x.is_zero() ? 0 : !v.y.is_zero() ? 1 : 2;
}

/// A line in the plane of a triangle with normal n. Corners p, q, r are taken relative to the line's origin. Seen along an axis
/// on which n is not zero, the inside of edge XY is where s cross(Y - X, t d - X) = s cross(X, Y) + t s cross(Y - X, d) >= 0,
/// with s the sign of n on that axis: each edge bounds t from one side, by its value and slope there.
template <int K>
[[nodiscard]] inline LineInterval<2 * K> clip_by_edges(const IntegerVec3<K>& d, const IntegerVec3<K>& p,
                                                       const IntegerVec3<K>& q, const IntegerVec3<K>& r,
                                                       const IntegerVec3<2 * K>& n, int scale) noexcept {
  const int axis = nonzero_axis(n);
  const bool flipped = component(n, axis).is_negative();
  std::optional<Quotient<2 * K>> first, last;
  const std::array<std::pair<const IntegerVec3<K>*, const IntegerVec3<K>*>, 3> edges{{{&p, &q}, {&q, &r}, {&r, &p}}};
  for (const auto& [x, y] : edges) {
    const Integer<2 * K> value = negate_if(flipped, component(cross(*x, *y), axis));
    const Integer<2 * K> slope = negate_if(flipped, component(cross(*y - *x, d), axis));
    const int direction = slope.sign();
    if (direction == 0) {
      if (value.is_negative()) return {};
      continue;
    }
    const Quotient<2 * K> t(-value, slope, scale);
    auto& end = direction > 0 ? first : last;
    if (!end || (direction > 0 ? t.compare_with(*end) > 0 : t.compare_with(*end) < 0)) end.emplace(t);
  }
  // d is not zero along the plane, and the three slopes sum to zero: one rises and one falls.
  if (first->compare_with(*last) > 0) return {};
  return std::pair{*first, *last};
}

/// A line and the segment pq, or the point p = q, relative to the line's origin.
template <int K>
[[nodiscard]] inline LineInterval<2 * K> meet_segment(const IntegerVec3<K>& d, const IntegerVec3<K>& p, const IntegerVec3<K>& q,
                                                      int scale) noexcept {
  using numeric::extend;
  const IntegerVec3<K> s = q - p;
  const IntegerVec3<2 * K> normal = cross(d, s);
  if (is_zero(normal)) {
    if (!is_zero(cross(d, p))) return {};
    const int axis = nonzero_axis(d);
    const Integer<2 * K> length = extend<2 * K>(component(d, axis));
    const Quotient<2 * K> tp(extend<2 * K>(component(p, axis)), length, scale);
    const Quotient<2 * K> tq(extend<2 * K>(component(q, axis)), length, scale);
    return tp.compare_with(tq) <= 0 ? std::pair{tp, tq} : std::pair{tq, tp};
  }
  if (!dot(normal, p).is_zero()) return {};
  // t d = p + w s. Crossed with s: t (d x s) = p x s. Crossed with d: w (d x s) = p x d.
  const int axis = nonzero_axis(normal);
  const bool flipped = component(normal, axis).is_negative();
  const Integer<2 * K> whole = negate_if(flipped, component(normal, axis));
  const Integer<2 * K> w = negate_if(flipped, component(cross(p, d), axis));
  if (w.is_negative() || compare(w, whole) > 0) return {};
  const Quotient<2 * K> t(component(cross(p, s), axis), component(normal, axis), scale);
  return std::pair{t, t};
}

/// The ends of the segment that three collinear corners span: the least and the greatest along an axis where they differ.
template <int K>
[[nodiscard]] inline std::pair<const IntegerVec3<K>*, const IntegerVec3<K>*> hull_ends(const IntegerVec3<K>& p,
                                                                                       const IntegerVec3<K>& q,
                                                                                       const IntegerVec3<K>& r) noexcept {
  std::pair<const IntegerVec3<K>*, const IntegerVec3<K>*> ends{&p, &p};
  for (int axis = 0; axis < 3 && ends.first == ends.second; ++axis) {
    for (const IntegerVec3<K>* corner : {&q, &r}) {
      if (compare(component(*corner, axis), component(*ends.first, axis)) < 0) ends.first = corner;
      if (compare(component(*corner, axis), component(*ends.second, axis)) > 0) ends.second = corner;
    }
  }
  return ends;
}

}  // namespace graze::exact
