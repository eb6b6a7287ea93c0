// Which inputs have an answer, told from their bits, in the contract's order.
#pragma once

#include "graze/answer.hpp"
#include "graze/numeric/bits.hpp"

namespace graze::exact {

/// `shape_is_finite` and `radius_is_negative` speak of the shape that the ray is asked about.
template <Real T>
[[nodiscard]] inline Status status_of(const Ray<T>& ray, bool shape_is_finite, bool radius_is_negative) noexcept {
  using namespace numeric;
  const bool bounds_are_valid = is_finite(ray.t_min) && (is_finite(ray.t_max) || bits_of(ray.t_max) == infinity_bits<T>);
  if (!is_finite(ray.origin) || !is_finite(ray.direction) || !bounds_are_valid || !shape_is_finite) return Status::non_finite;
  if (numeric::is_zero(ray.direction)) return Status::zero_direction;
  if (radius_is_negative) return Status::negative_radius;
  if (order_key(ray.t_min) > order_key(ray.t_max)) return Status::empty_range;
  return Status::ok;
}

template <Real T>
[[nodiscard]] inline bool is_finite(const Sphere<T>& s) noexcept {
  return numeric::is_finite(s.center) && numeric::is_finite(s.radius);
}

template <Real T>
[[nodiscard]] inline Status status_of(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return status_of(ray, is_finite(sphere), numeric::is_negative(sphere.radius));
}

template <Real T>
[[nodiscard]] inline Status status_of(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  const auto& [a, b, c] = triangle;
  return status_of(ray, numeric::is_finite(a) && numeric::is_finite(b) && numeric::is_finite(c), false);
}

}  // namespace graze::exact
