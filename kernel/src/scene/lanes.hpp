// What the filter on a block of triangles takes and leaves.
#pragma once

#include "graze/triangle.hpp"
#include "scene/node.hpp"

namespace graze::scene {

/// A ray as the filter on lanes sees it.
template <Real T>
struct RayLanes {
  Vec3<T> origin, direction;
  T direction_sum, t_min, t_max;
  T end = 0;  ///< where `has_end`, hits beyond this do not matter
  bool has_default_range, has_t_max, has_end = false;
  bool range_is_plain;  ///< whether the filter takes the ray's range

  explicit RayLanes(const Ray<T>& ray) noexcept
      : origin(ray.origin),
        direction(ray.direction),
        direction_sum(numeric::magnitude(ray.direction.x) + numeric::magnitude(ray.direction.y) +
                      numeric::magnitude(ray.direction.z)),
        t_min(ray.t_min),
        t_max(ray.t_max),
        has_default_range(numeric::is_default_range(ray)),
        has_t_max(numeric::is_finite(ray.t_max)),
        range_is_plain(has_default_range || numeric::is_ordinary_range<T>(ray)) {}

  /// From now on hits beyond t do not matter, where that is a number that the filter takes.
  void end_at(double t) noexcept {
    using Ordinary = numeric::Ordinary<T, T>;
    has_end = t >= static_cast<double>(Ordinary::low) && t <= static_cast<double>(Ordinary::bound_high) / 2;
    // Not below t, in every rounding mode.
    if (has_end) end = sizeof(T) < sizeof(double) ? static_cast<T>(t * (1 + 0x1p-22)) : static_cast<T>(t);
  }
};

/// Bits of lanes. What is in neither is missed for certain.
struct LaneVerdicts {
  unsigned face, uncertain;
};

}  // namespace graze::scene
