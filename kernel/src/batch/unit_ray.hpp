// The one ray of a batch, made ready for unit_spheres-inl.hpp.
#pragma once

#include <optional>

#include "batch/bounds.hpp"
#include "batch/verdicts.hpp"
#include "graze/numeric/filter.hpp"
#include "numeric/double_double.hpp"

namespace graze::batch {

/// Nothing for a ray that has a range, or whose direction is of extreme size or invalid; nor in directed rounding, where an
/// overflow may give the largest finite number, and no infinity tells of it.
template <Real T>
[[nodiscard]] inline std::optional<UnitRay<T>> unit_ray(const Ray<T>& ray) noexcept {
  using namespace numeric;
  if (!is_default_range(ray) || !rounds_to_nearest()) return {};
  const auto& [e, d, t_min, t_max] = ray;
  const T square = d.x * d.x + d.y * d.y + d.z * d.z;
  if (!(square >= Bounds<T>::low * Bounds<T>::low && square <= Bounds<T>::high * Bounds<T>::high)) return {};
  const T length = square_root(square);
  return UnitRay<T>{{e.x, e.y, e.z}, {d.x / length, d.y / length, d.z / length}};
}

}  // namespace graze::batch
