// Why an input has no answer, in the order of the contract.
#pragma once

#include "graze/answer.hpp"
#include "oracle/gmp_dyadic.hpp"

namespace graze::oracle::gmp {

template <Real T>
[[nodiscard]] bool is_finite(const Vec2<T>& v) {
  return is_finite(v.x) && is_finite(v.y);
}
template <Real T>
[[nodiscard]] bool is_finite(const Vec3<T>& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
template <Real T>
[[nodiscard]] bool is_finite(const Ray<T>& ray) {
  const bool unbounded = order(ray.t_max) == static_cast<std::int64_t>(Format<T>::kInfinity);
  return is_finite(ray.origin) && is_finite(ray.direction) && is_finite(ray.t_min) && (unbounded || is_finite(ray.t_max));
}
template <Real T>
[[nodiscard]] bool is_finite(const Sphere<T>& sphere) {
  return is_finite(sphere.center) && is_finite(sphere.radius);
}
template <Real T>
[[nodiscard]] bool is_finite(const Triangle<T>& triangle) {
  return is_finite(triangle.a) && is_finite(triangle.b) && is_finite(triangle.c);
}
template <Real T>
[[nodiscard]] bool is_finite(const Line<T>& line) {
  return is_finite(line.a) && is_finite(line.b) && is_finite(line.c);
}
template <Real T>
[[nodiscard]] bool is_finite(const Plane<T>& plane) {
  return is_finite(plane.a) && is_finite(plane.b) && is_finite(plane.c) && is_finite(plane.d);
}

template <Real T>
[[nodiscard]] bool has_zero_direction(const Ray<T>& ray) {
  return order(ray.direction.x) == 0 && order(ray.direction.y) == 0 && order(ray.direction.z) == 0;
}

template <Real T>
[[nodiscard]] Status status_of(const Ray<T>& ray, const Sphere<T>& sphere) {
  if (!is_finite(ray) || !is_finite(sphere)) return Status::non_finite;
  if (has_zero_direction(ray)) return Status::zero_direction;
  if (order(sphere.radius) < 0) return Status::negative_radius;
  if (order(ray.t_min) > order(ray.t_max)) return Status::empty_range;
  return Status::ok;
}

template <Real T>
[[nodiscard]] Status status_of(const Ray<T>& ray, const Triangle<T>& triangle) {
  if (!is_finite(ray) || !is_finite(triangle)) return Status::non_finite;
  if (has_zero_direction(ray)) return Status::zero_direction;
  if (order(ray.t_min) > order(ray.t_max)) return Status::empty_range;
  return Status::ok;
}

template <class Point, class Surface>
[[nodiscard]] Status status_of(const Point& point, const Surface& surface) {
  if (!is_finite(point) || !is_finite(surface)) return Status::non_finite;
  if constexpr (requires { surface.radius; }) {
    if (order(surface.radius) < 0) return Status::negative_radius;
  }
  return Status::ok;
}

}  // namespace graze::oracle::gmp
