// Why an input has no answer, in the order of the contract; CGAL never sees such an input.
#pragma once

#include <cmath>

#include "graze/answer.hpp"

namespace graze::oracle::cgal {

template <class... Numbers>
[[nodiscard]] bool all_finite(Numbers... numbers) {
  return (std::isfinite(numbers) && ...);
}

template <Real T>
[[nodiscard]] bool all_finite(const Vec3<T>& v) {
  return all_finite(v.x, v.y, v.z);
}

template <Real T>
[[nodiscard]] bool all_finite(const Ray<T>& ray) {
  const bool upper_end = ray.t_max == std::numeric_limits<T>::infinity() || std::isfinite(ray.t_max);
  return all_finite(ray.origin) && all_finite(ray.direction) && std::isfinite(ray.t_min) && upper_end;
}

template <Real T>
[[nodiscard]] bool has_zero_direction(const Ray<T>& ray) {
  return ray.direction == Vec3<T>{};
}

template <Real T>
[[nodiscard]] Status status_of(const Ray<T>& ray, const Sphere<T>& sphere) {
  if (!all_finite(ray) || !all_finite(sphere.center) || !all_finite(sphere.radius)) return Status::non_finite;
  if (has_zero_direction(ray)) return Status::zero_direction;
  if (sphere.radius < 0) return Status::negative_radius;
  return ray.t_min > ray.t_max ? Status::empty_range : Status::ok;
}

template <Real T>
[[nodiscard]] Status status_of(const Ray<T>& ray, const Triangle<T>& triangle) {
  if (!all_finite(ray) || !all_finite(triangle.a) || !all_finite(triangle.b) || !all_finite(triangle.c)) {
    return Status::non_finite;
  }
  if (has_zero_direction(ray)) return Status::zero_direction;
  return ray.t_min > ray.t_max ? Status::empty_range : Status::ok;
}

}  // namespace graze::oracle::cgal
