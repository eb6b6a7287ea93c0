// The one ray of a batch, made ready for sheared_triangles-inl.hpp.
#pragma once

#include <optional>

#include "batch/bounds.hpp"
#include "batch/columns.hpp"
#include "batch/verdicts.hpp"
#include "graze/numeric/filter.hpp"

namespace graze::batch {

/// Nothing for a ray that the lanes can't take: a direction or a range of extreme size, or an invalid ray. Of the direction's
/// longest component it is asked that nothing that underflows matters beside it.
template <Real T>
[[nodiscard]] inline std::optional<ShearedRay<T>> shear(const Ray<T>& ray) noexcept {
  using namespace numeric;
  constexpr T low = sizeof(T) == sizeof(float) ? T(0x1p-60) : T(0x1p-500),
              high = sizeof(T) == sizeof(float) ? T(0x1p60) : T(0x1p500);
  const bool has_end = bits_of(ray.t_max) != infinity_bits<T>;
  if (!is_finite(ray.t_min) || (has_end && !is_finite(ray.t_max)) || order_key(ray.t_min) > order_key(ray.t_max)) return {};
  const T e[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const Bits<T> sizes[3] = {magnitude_bits(d[0]), magnitude_bits(d[1]), magnitude_bits(d[2])};
  const int last = sizes[0] >= sizes[1] ? (sizes[0] >= sizes[2] ? 0 : 2) : (sizes[1] >= sizes[2] ? 1 : 2);
  if (sizes[last] < bits_of(low) || sizes[last] > bits_of(high)) return {};
  const int first = (last + 1) % 3, second = (last + 2) % 3;
  ShearedRay<T> out{{e[first], e[second], e[last]},
                    {d[first] / d[last], d[second] / d[last]},
                    0,
                    0,
                    {first, second, last},
                    d[last] < 0,
                    magnitude_bits(ray.t_min) != 0,
                    has_end};
  if (out.has_least) out.least = ray.t_min * d[last];
  if (out.has_most) out.most = ray.t_max * d[last];
  if (!(__builtin_fabs(out.least) <= Bounds<T>::high && __builtin_fabs(out.most) <= Bounds<T>::high)) return {};
  return out;
}

/// The triangles' columns in the order of the ray's axes.
template <Real T>
[[nodiscard]] inline TriangleColumns<T> columns_along(const ShearedRay<T>& ray, const TriangleArrays<T>& triangles) noexcept {
  const TriangleColumns<T> c = columns(triangles);
  TriangleColumns<T> along{};
  for (int corner = 0; corner < 9; corner += 3) {
    for (int k = 0; k < 3; ++k) along.column[corner + k] = c.column[corner + ray.axis[k]];
  }
  return along;
}

}  // namespace graze::batch
