// Parametric forms: the point for given parameters. The computed point is rounded, so it lies near the ray or the triangle
// and hardly ever on it: a ray that starts there may meet the same surface again.
#pragma once

#include "graze/textbook/vector.hpp"
#include "graze/types.hpp"

namespace graze::textbook {

/// e + t d. Far out, the spacing of the sum's format is the error.
template <Real T>
[[nodiscard]] constexpr Vec3<T> point_at(const Ray<T>& ray, T t) noexcept {
  const Vec3<T>& e = ray.origin;
  const Vec3<T>& d = ray.direction;
  return {e.x + t * d.x, e.y + t * d.y, e.z + t * d.z};
}

/// a + u (b - a) + v (c - a). At u = 1, v = 0 it need not be b: b - a is rounded.
template <Real T>
[[nodiscard]] constexpr Vec3<T> point_at(const Triangle<T>& triangle, T u, T v) noexcept {
  const Vec3<T> ab = difference(triangle.b, triangle.a);
  const Vec3<T> ac = difference(triangle.c, triangle.a);
  return {triangle.a.x + u * ab.x + v * ac.x, triangle.a.y + u * ab.y + v * ac.y, triangle.a.z + u * ab.z + v * ac.z};
}

}  // namespace graze::textbook
