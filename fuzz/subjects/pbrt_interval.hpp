// Ray and sphere as in Pharr, Jakob and Humphreys, "Physically based rendering", 4th edition, section 6.2: every operation on
// intervals that are rounded outward, the discriminant as 4 a (r + |v|) (r - |v|) with v the offset of the point nearest to the
// center, and the nearer root that is certainly in the range. Where an interval does not decide, it is a miss: a discriminant
// whose lower bound is negative has no roots, a root whose lower bound lies below the range is not taken. So it loses every
// tangent and near-tangent and every hit at an end of the range, on purpose: a renderer then meets no surface twice. Other
// failures: intervals that blow up where squares overflow. pbrt leaves t = 0 itself out; here the ends of the range belong to
// it. One root is told, the middle of its interval.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"

namespace graze::fuzz::pbrt_interval {

template <Real T>
struct Interval {
  T low{}, high{};

  Interval() = default;
  explicit Interval(T exact) : low(exact), high(exact) {}
  Interval(T l, T h) : low(l), high(h) {}
  [[nodiscard]] T middle() const { return low + (high - low) / 2; }
};

template <Real T>
Interval<T> outward(T low, T high) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (std::isnan(low) || std::isnan(high)) return {-infinity, infinity};
  return {std::nextafter(low, -infinity), std::nextafter(high, infinity)};
}

template <Real T>
Interval<T> operator+(const Interval<T>& a, const Interval<T>& b) {
  return outward(a.low + b.low, a.high + b.high);
}
template <Real T>
Interval<T> operator-(const Interval<T>& a, const Interval<T>& b) {
  return outward(a.low - b.high, a.high - b.low);
}
template <Real T>
Interval<T> operator*(const Interval<T>& a, const Interval<T>& b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return outward(low, high);
}
template <Real T>
Interval<T> operator/(const Interval<T>& a, const Interval<T>& b) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (b.low <= 0 && b.high >= 0) return {-infinity, infinity};
  const auto [low, high] = std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
  return outward(low, high);
}
template <Real T>
Interval<T> square(const Interval<T>& a) {
  const T l = std::abs(a.low), h = std::abs(a.high), least = a.low <= 0 && a.high >= 0 ? T(0) : std::min(l, h);
  const Interval<T> s = outward(least * least, std::max(l, h) * std::max(l, h));
  return {std::max(s.low, T(0)), s.high};
}
template <Real T>
Interval<T> root(const Interval<T>& a) {
  const Interval<T> r = outward(std::sqrt(std::max(a.low, T(0))), std::sqrt(a.high));
  return {std::max(r.low, T(0)), r.high};
}

struct Formula {
  static constexpr std::string_view name = "pbrt-interval";
  static constexpr std::string_view about =
      "outward intervals, a doubtful hit is a miss; Pharr, Jakob, Humphreys, Physically based rendering, 4th edition, 6.2";
  static constexpr Deviations deviations{
      {Deviation::nearest_root, Deviation::no_root, Deviation::no_origin, Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    const Ray<T>& ray = query.ray;
    const Interval<T> radius(query.sphere.radius), half(T(0.5)), two(T(2)), four(T(4));
    const Interval<T> d[3] = {Interval<T>(ray.direction.x), Interval<T>(ray.direction.y), Interval<T>(ray.direction.z)};
    const Interval<T> o[3] = {Interval<T>(ray.origin.x) - Interval<T>(query.sphere.center.x),
                              Interval<T>(ray.origin.y) - Interval<T>(query.sphere.center.y),
                              Interval<T>(ray.origin.z) - Interval<T>(query.sphere.center.z)};
    const Interval<T> a = square(d[0]) + square(d[1]) + square(d[2]);
    const Interval<T> b = two * (d[0] * o[0] + d[1] * o[1] + d[2] * o[2]);
    const Interval<T> c = square(o[0]) + square(o[1]) + square(o[2]) - square(radius);
    const Interval<T> along = b / (two * a);
    const Interval<T> distance = root(square(o[0] - along * d[0]) + square(o[1] - along * d[1]) + square(o[2] - along * d[2]));
    const Interval<T> discriminant = four * a * (radius + distance) * (radius - distance);
    if (!(discriminant.low >= 0)) return {};
    const Interval<T> spread = root(discriminant);
    const Interval<T> q = (b.middle() < 0 ? spread - b : Interval<T>(-(b + spread).high, -(b + spread).low)) * half;
    Interval<T> t0 = q / a, t1 = c / q;
    if (t0.low > t1.low) std::swap(t0, t1);
    const Interval<T>& t = t0.low >= ray.t_min ? t0 : t1;
    if (!(t.low >= ray.t_min && t.high <= ray.t_max)) return {};
    SphereHit<T> hit;
    hit.kind = SphereKind::secant;
    hit.root = Root::first;
    hit.t[0] = t.middle();
    return hit;
  }
};

}  // namespace graze::fuzz::pbrt_interval
