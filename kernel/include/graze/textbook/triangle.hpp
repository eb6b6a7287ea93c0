// Ray and triangle as the linear system a + u (b - a) + v (c - a) = e + t d in u, v, t.
#pragma once

#include "graze/answer.hpp"
#include "graze/textbook/vector.hpp"
#include "graze/types.hpp"

namespace graze::textbook {

/// Which part of the triangle has the coordinates u, v; miss where none has, or one is NaN.
/// The three tests are u >= 0, v >= 0, u + v <= 1. A slip met in lecture notes is `1 - u < u` for the last one, another is to
/// test v alone against 1: both accept points outside, and the first loses half of the inside. The sum is rounded here, so even
/// the right test lets a hair of the outside in and calls points beside the edge b c points on it.
template <Real T>
[[nodiscard]] constexpr TriangleKind kind_at(T u, T v) noexcept {
  if (!(u >= 0 && v >= 0 && u + v <= 1)) return TriangleKind::miss;
  const bool on_bc = u + v == 1;
  if (u == 0) return v == 0 ? TriangleKind::vertex_a : on_bc ? TriangleKind::vertex_c : TriangleKind::edge_ca;
  if (v == 0) return on_bc ? TriangleKind::vertex_b : TriangleKind::edge_ab;
  return on_bc ? TriangleKind::edge_bc : TriangleKind::face;
}

/// Cramer's rule on the 3x3 system with the columns a - b, a - c, d and the right-hand side a - e.
/// Fails where a determinant cancels: rays through corners and edges slip between two triangles that share them or hit both,
/// nearly parallel rays and slivers give u, v, t without a right digit. A determinant that is 0, or underflows to 0, is a miss,
/// so coplanar rays and degenerate triangles are never hit; one that is not 0 by rounding alone gives nonsense. No input is
/// validated. Source: Shirley, Marschner, "Fundamentals of Computer Graphics", section 4.4.2.
namespace cramer {

/// The solution as computed; infinities and NaN where determinant is 0. The determinant is d . n, n = (b - a) x (c - a).
template <Real T>
struct Solution {
  T determinant{}, u{}, v{}, t{};
};

template <Real T>
[[nodiscard]] constexpr Solution<T> solve(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  const Vec3<T> ba = difference(triangle.a, triangle.b);
  const Vec3<T> ca = difference(triangle.a, triangle.c);
  const Vec3<T> ea = difference(triangle.a, ray.origin);
  const Vec3<T> ca_d = cross(ca, ray.direction);
  const Vec3<T> ba_ea = cross(ba, ea);
  const T determinant = dot(ba, ca_d);
  return {determinant, dot(ea, ca_d) / determinant, dot(ray.direction, ba_ea) / determinant, -dot(ca, ba_ea) / determinant};
}

template <Real T>
[[nodiscard]] constexpr TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  TriangleHit<T> hit;
  const Solution<T> s = solve(ray, triangle);
  hit.facing = s.determinant < 0 ? Facing::front : s.determinant > 0 ? Facing::back : Facing::none;
  if (s.determinant == 0 || !(ray.t_min <= s.t && s.t <= ray.t_max)) return hit;
  hit.kind = kind_at(s.u, s.v);
  if (hit.kind == TriangleKind::miss) return hit;
  hit.t = hit.t_end = s.t;
  hit.u = s.u;
  hit.v = s.v;
  return hit;
}

/// intersect(ray, triangle).kind != miss, with early exits: t first, as in the source.
template <Real T>
[[nodiscard]] constexpr bool hits(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  const Vec3<T> ba = difference(triangle.a, triangle.b);
  const Vec3<T> ca = difference(triangle.a, triangle.c);
  const Vec3<T> ea = difference(triangle.a, ray.origin);
  const Vec3<T> ca_d = cross(ca, ray.direction);
  const T determinant = dot(ba, ca_d);
  if (determinant == 0) return false;
  const Vec3<T> ba_ea = cross(ba, ea);
  const T t = -dot(ca, ba_ea) / determinant;
  if (!(ray.t_min <= t && t <= ray.t_max)) return false;
  const T v = dot(ray.direction, ba_ea) / determinant;
  if (!(v >= 0)) return false;
  const T u = dot(ea, ca_d) / determinant;
  return u >= 0 && u + v <= 1;
}

}  // namespace cramer
}  // namespace graze::textbook
