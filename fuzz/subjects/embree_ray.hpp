// A ray as Embree 3 is asked it.
#pragma once

#include <embree3/rtcore.h>

#include "graze/types.hpp"

namespace graze::fuzz {

/// Nothing hit yet, every geometry seen, time 0.
[[nodiscard]] inline RTCRayHit embree_ray(const Ray<float>& ray) {
  RTCRayHit query;
  query.ray = {ray.origin.x,
               ray.origin.y,
               ray.origin.z,
               ray.t_min,
               ray.direction.x,
               ray.direction.y,
               ray.direction.z,
               0,
               ray.t_max,
               ~0u,
               0,
               0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

}  // namespace graze::fuzz
