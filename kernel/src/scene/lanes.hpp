// What the filter on a block of triangles takes and leaves.
#pragma once

#include "graze/triangle.hpp"
#include "numeric/dyadic.hpp"
#include "scene/triangle_block.hpp"

namespace graze::scene {

/// Whether determinants of such numbers are exact in double. With coordinates below 2^15 in their unit, differences are below
/// 2^16, components of the direction below 2^15, a component of a cross product is the sum of two products, a determinant of
/// three: the distance, of three differences, is below 6 * 2^48 < 2^51, the others, of two, below 6 * 2^47. So no operation
/// rounds, in any mode, fused or not; and with all exponents within 100 none overflows or underflows, not even in the
/// conversion of a float.
[[nodiscard]] inline bool is_small(const numeric::Extent& extent) noexcept {
  return extent.width() <= 15 && (extent.width() <= 0 || (extent.low >= -100 && extent.high <= 100));
}

/// A ray as the filter on lanes sees it.
template <Real T>
struct RayLanes {
  const Ray<T>& ray;
  T direction_sum;
  T end = 0;    ///< where `has_end`, hits beyond this do not matter
  T t_max = 0;  ///< where the range is not the default: the ray's, or the greatest that the filter takes if that is less
  bool has_default_range, has_t_max, is_t_max_greater = false, has_end = false;
  bool range_is_plain;      ///< whether the filter takes the ray's range
  bool is_integer = false;  ///< whether all triangles' determinants are exact in double

  /// `extent` is of all the scene's corners.
  RayLanes(const Ray<T>& from, const numeric::Extent& extent) noexcept
      : ray(from),
        direction_sum(numeric::magnitude(ray.direction.x) + numeric::magnitude(ray.direction.y) +
                      numeric::magnitude(ray.direction.z)),
        has_default_range(numeric::is_default_range(ray)),
        has_t_max(numeric::is_finite(ray.t_max)),
        range_is_plain(has_default_range || take_range()) {
    if (!has_default_range || !is_small(extent)) return;
    numeric::Extent with_origin = extent, alone;
    with_origin.include(numeric::dyadic(ray.origin));
    alone.include(numeric::dyadic(ray.direction));
    is_integer = is_small(with_origin) && is_small(alone);
  }

  /// From now on hits beyond t do not matter, where that is a number that the filter takes.
  void end_at(double t) noexcept {
    using Ordinary = numeric::Ordinary<T, T>;
    has_end = t >= static_cast<double>(Ordinary::low) && t <= static_cast<double>(Ordinary::bound_high) / 2;
    // Not below t, in every rounding mode.
    if (has_end) end = sizeof(T) < sizeof(double) ? static_cast<T>(t * (1 + 0x1p-22)) : static_cast<T>(t);
  }

 private:
  /// Sets t_max and is_t_max_greater; returns whether the filter takes the range. Many give the greatest number for t_max, and
  /// mean none.
  [[nodiscard]] bool take_range() noexcept {
    constexpr T most = numeric::Ordinary<T, T>::bound_high;
    t_max = ray.t_max;
    is_t_max_greater = has_t_max && t_max > most;
    if (is_t_max_greater) t_max = most;
    return numeric::is_ordinary_range<T>(Ray<T>{ray.origin, ray.direction, ray.t_min, t_max});
  }
};

/// Bits of lanes. What is in neither is missed for certain.
struct LaneVerdicts {
  unsigned face, uncertain;
};

/// What the filter has computed of lanes in the format's own precision, as predicates::TriangleTerms; good for those in `face`.
template <Real T>
struct LaneTerms {
  unsigned front;  ///< bits: the ray comes from the front
  alignas(64) T whole[width], distance[width], error[width], distance_error[width];
};

/// Of exact determinants, the sign of `whole` taken out of all. What is in neither `met` nor `uncertain` is missed.
struct IntegerVerdicts {
  unsigned met = 0;        ///< one common point
  unsigned inner = 0;      ///< of these, those in the face, with t > 0
  unsigned uncertain = 0;  ///< the ray runs in the plane, or there is none
  unsigned front = 0;      ///< the ray comes from the front
  alignas(64) double whole[width], u[width], v[width], distance[width];
};

}  // namespace graze::scene
