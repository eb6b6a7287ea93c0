// Ray and triangle by Moeller and Trumbore, "Fast, minimum storage ray/triangle intersection", Journal of Graphics Tools 2(1),
// 1997: the two-sided branch, with no epsilon about the determinant and with the ray's range. Fails as Cramer's rule in
// textbook/triangle.hpp does, of which it is an arrangement: the same ray gives unlike edge signs in two triangles that share
// an edge, so rays through corners and edges are lost or counted twice. The reciprocal adds a rounding, and overflows for a
// subnormal determinant. Coplanar rays and degenerate triangles are misses.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/answer.hpp"
#include "graze/textbook/triangle.hpp"
#include "graze/textbook/vector.hpp"
#include "graze/types.hpp"

namespace graze::fuzz::moller_trumbore {

template <Real T>
[[nodiscard]] constexpr TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  TriangleHit<T> hit;
  const Vec3<T> edge1 = textbook::difference(triangle.b, triangle.a);
  const Vec3<T> edge2 = textbook::difference(triangle.c, triangle.a);
  const Vec3<T> p = textbook::cross(ray.direction, edge2);
  const T determinant = textbook::dot(edge1, p);  // -(d . n)
  hit.facing = determinant > 0 ? Facing::front : determinant < 0 ? Facing::back : Facing::none;
  if (determinant == 0) return hit;
  const T inverse = 1 / determinant;
  const Vec3<T> from_a = textbook::difference(ray.origin, triangle.a);
  const T u = textbook::dot(from_a, p) * inverse;
  const Vec3<T> q = textbook::cross(from_a, edge1);
  const T v = textbook::dot(ray.direction, q) * inverse;
  const T t = textbook::dot(edge2, q) * inverse;
  if (!(ray.t_min <= t && t <= ray.t_max)) return hit;
  hit.kind = textbook::kind_at(u, v);
  if (hit.kind == TriangleKind::miss) return hit;
  hit.t = hit.t_end = t;
  hit.u = u;
  hit.v = v;
  return hit;
}

/// intersect(ray, triangle).kind != miss, with the early exits of the paper.
template <Real T>
[[nodiscard]] constexpr bool hits(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  const Vec3<T> edge1 = textbook::difference(triangle.b, triangle.a);
  const Vec3<T> edge2 = textbook::difference(triangle.c, triangle.a);
  const Vec3<T> p = textbook::cross(ray.direction, edge2);
  const T determinant = textbook::dot(edge1, p);
  if (determinant == 0) return false;
  const T inverse = 1 / determinant;
  const Vec3<T> from_a = textbook::difference(ray.origin, triangle.a);
  const T u = textbook::dot(from_a, p) * inverse;
  if (!(u >= 0 && u <= 1)) return false;
  const Vec3<T> q = textbook::cross(from_a, edge1);
  const T v = textbook::dot(ray.direction, q) * inverse;
  if (!(v >= 0 && u + v <= 1)) return false;
  const T t = textbook::dot(edge2, q) * inverse;
  return ray.t_min <= t && t <= ray.t_max;
}

struct Formula {
  static constexpr std::string_view name = "moller-trumbore";
  static constexpr std::string_view about =
      "Moeller, Trumbore, Fast, minimum storage ray/triangle intersection, JGT 2(1) 1997; two-sided, no epsilon";

  static constexpr Deviations deviations{
      {Deviation::coplanar_is_miss, Deviation::degenerate_is_miss, Deviation::invalid_unhandled}};

  template <Real T>
  static TriangleHit<T> answer(const RayTriangle<T>& query) {
    return moller_trumbore::intersect(query.ray, query.triangle);
  }
};

}  // namespace graze::fuzz::moller_trumbore
