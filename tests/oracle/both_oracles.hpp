// Each claim is put to both oracles, in both precisions.
#pragma once

#include <cmath>
#include <limits>
#include <ostream>

#include "oracle/oracle.hpp"
#include "tests/catch.hpp"

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

namespace graze::oracle {

/// Runs test.operator()<T>(oracle) for both formats T and both oracles.
template <class Test>
void everywhere(Test test) {
  for (const Oracle* oracle : {&gmp_oracle(), &cgal_oracle()}) {
    CAPTURE(oracle->name());
    {
      INFO("float");
      test.template operator()<float>(*oracle);
    }
    {
      INFO("double");
      test.template operator()<double>(*oracle);
    }
  }
}

template <Real T>
inline constexpr T kInfinity = std::numeric_limits<T>::infinity();

/// The least number above zero.
template <Real T>
inline constexpr T kLeast = std::numeric_limits<T>::denorm_min();

template <Real T>
inline constexpr T kGreatest = std::numeric_limits<T>::max();

/// Answers made by hand.
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

}  // namespace graze::oracle
