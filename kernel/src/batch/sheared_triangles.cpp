// One ray and triangles in lanes, compiled for each instruction set.
// The order is Highway's: the targets, then this file again for each, then what it includes.
// clang-format off
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/sheared_triangles.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep

#include "batch/lanes-inl.hpp"
#include "batch/sheared_triangles-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

template <class T>
HWY_INLINE void settle_lanes(const ShearedRay<T>& ray, const TriangleColumns<T>& triangles, std::size_t first,
                             std::size_t count, Verdicts& out) {
  using D = Tag<T>;
  const D d;
  const Columns<T, 1> none{};
  if (ray.has_most)
    return settle<D, false, true>(d, none, triangles, first, count, ShearedTriangles<D, true, true>(d, ray), out);
  if (ray.has_least)
    return settle<D, false, true>(d, none, triangles, first, count, ShearedTriangles<D, true, false>(d, ray), out);
  settle<D, false, true>(d, none, triangles, first, count, ShearedTriangles<D, false, false>(d, ray), out);
}

void float_run(const ShearedRay<float>& ray, const TriangleColumns<float>& triangles, std::size_t first, std::size_t count,
               Verdicts& out) {
  settle_lanes(ray, triangles, first, count, out);
}
void double_run(const ShearedRay<double>& ray, const TriangleColumns<double>& triangles, std::size_t first, std::size_t count,
                Verdicts& out) {
  settle_lanes(ray, triangles, first, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(float_run);
HWY_EXPORT(double_run);

template <>
void settle(const ShearedRay<float>& ray, const TriangleColumns<float>& triangles, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(float_run)(ray, triangles, first, count, out);
}
template <>
void settle(const ShearedRay<double>& ray, const TriangleColumns<double>& triangles, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(double_run)(ray, triangles, first, count, out);
}

}  // namespace graze::batch
#endif
