// Permutations and reflections of the axes: exact, so they must not change a bit of an answer.
#pragma once

#include <array>

#include "fuzz/case.hpp"

namespace graze::test {

/// Sends v to (s0 v[p0], s1 v[p1], s2 v[p2]).
struct Isometry {
  std::array<int, 3> axis;
  std::array<int, 3> sign;

  template <Real T>
  [[nodiscard]] Vec3<T> operator()(const Vec3<T>& v) const {
    const std::array<T, 3> from{v.x, v.y, v.z};
    const auto component = [&](std::size_t i) { return static_cast<T>(sign[i]) * from[static_cast<std::size_t>(axis[i])]; };
    return {component(0), component(1), component(2)};
  }
  template <Real T>
  [[nodiscard]] fuzz::RaySphere<T> operator()(const fuzz::RaySphere<T>& q) const {
    return {{(*this)(q.ray.origin), (*this)(q.ray.direction), q.ray.t_min, q.ray.t_max},
            {(*this)(q.sphere.center), q.sphere.radius}};
  }
  template <Real T>
  [[nodiscard]] fuzz::RayTriangle<T> operator()(const fuzz::RayTriangle<T>& q) const {
    return {{(*this)(q.ray.origin), (*this)(q.ray.direction), q.ray.t_min, q.ray.t_max},
            {(*this)(q.triangle.a), (*this)(q.triangle.b), (*this)(q.triangle.c)}};
  }
  template <Real T>
  [[nodiscard]] fuzz::PointSphere<T> operator()(const fuzz::PointSphere<T>& q) const {
    return {(*this)(q.point), {(*this)(q.sphere.center), q.sphere.radius}};
  }

  /// Whether left and right are exchanged.
  [[nodiscard]] bool flips() const {
    const bool odd = axis[0] == 0 ? axis[1] == 2 : axis[1] == 1 ? axis[0] == 2 : axis[0] == 1 && axis[1] == 0;
    return (sign[0] * sign[1] * sign[2] < 0) != odd;
  }
};

/// Calls visit(isometry) for all 48.
template <class Visit>
void each_isometry(Visit visit) {
  constexpr std::array<std::array<int, 3>, 6> orders{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const auto& order : orders) {
    for (int signs = 0; signs < 8; ++signs) {
      visit(Isometry{order, {(signs & 1) != 0 ? -1 : 1, (signs & 2) != 0 ? -1 : 1, (signs & 4) != 0 ? -1 : 1}});
    }
  }
}

}  // namespace graze::test
