// Answers made by hand, and how Catch2 prints an answer.
#pragma once

#include <limits>
#include <ostream>

#include "graze/answer.hpp"

namespace graze {

template <Real T>
std::ostream& operator<<(std::ostream& out, const SphereHit<T>& hit) {
  out << std::hexfloat << "status " << int(hit.status) << " kind " << int(hit.kind) << " root " << int(hit.root) << " origin "
      << int(hit.origin) << " t " << hit.t[0] << ' ' << hit.t[1];
  return out << std::defaultfloat;
}

template <Real T>
std::ostream& operator<<(std::ostream& out, const TriangleHit<T>& hit) {
  out << std::hexfloat << "status " << int(hit.status) << " kind " << int(hit.kind) << " facing " << int(hit.facing) << " t "
      << hit.t << ' ' << hit.t_end << " uv " << hit.u << ' ' << hit.v;
  return out << std::defaultfloat;
}

inline std::ostream& operator<<(std::ostream& out, const Side& side) {
  return out << "status " << int(side.status) << " sign " << int(side.sign);
}

}  // namespace graze

namespace graze::test {

template <Real T>
inline constexpr T kInfinity = std::numeric_limits<T>::infinity();

/// The least number above zero.
template <Real T>
inline constexpr T kLeast = std::numeric_limits<T>::denorm_min();

template <Real T>
inline constexpr T kGreatest = std::numeric_limits<T>::max();

template <Real T>
[[nodiscard]] SphereHit<T> sphere_miss(OriginSide origin) {
  SphereHit<T> hit;
  hit.origin = origin;
  return hit;
}
template <Real T>
[[nodiscard]] SphereHit<T> tangent(OriginSide origin, T t) {
  return {Status::ok, SphereKind::tangent, Root::both, origin, {t, 0}};
}
template <Real T>
[[nodiscard]] SphereHit<T> secant(OriginSide origin, T first, T second) {
  return {Status::ok, SphereKind::secant, Root::both, origin, {first, second}};
}
template <Real T>
[[nodiscard]] SphereHit<T> lone(OriginSide origin, Root root, T t) {
  return {Status::ok, SphereKind::secant, root, origin, {t, 0}};
}
template <Real T>
[[nodiscard]] SphereHit<T> invalid_sphere(Status status) {
  SphereHit<T> hit;
  hit.status = status;
  hit.kind = SphereKind::invalid;
  return hit;
}

template <Real T>
[[nodiscard]] TriangleHit<T> triangle_miss(Facing facing) {
  TriangleHit<T> hit;
  hit.facing = facing;
  return hit;
}
template <Real T>
[[nodiscard]] TriangleHit<T> at_point(TriangleKind kind, Facing facing, T t, T u, T v) {
  return {Status::ok, kind, facing, t, t, u, v};
}
template <Real T>
[[nodiscard]] TriangleHit<T> along(TriangleKind kind, T t, T t_end) {
  return {Status::ok, kind, Facing::none, t, t_end, 0, 0};
}
template <Real T>
[[nodiscard]] TriangleHit<T> invalid_triangle(Status status) {
  TriangleHit<T> hit;
  hit.status = status;
  hit.kind = TriangleKind::invalid;
  return hit;
}

}  // namespace graze::test
