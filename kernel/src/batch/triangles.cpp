// Rays and triangles in lanes, compiled for each instruction set.
// The order is Highway's: the targets, then this file again for each, then what it includes.
// clang-format off
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/triangles.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep

#include "batch/lanes-inl.hpp"
#include "batch/triangles-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

void float_run(const TriangleRun<float>& run, std::size_t first, std::size_t count, Verdicts& out) {
  settle_run<TriangleFilter>(run, first, count, out);
}
void double_run(const TriangleRun<double>& run, std::size_t first, std::size_t count, Verdicts& out) {
  settle_run<TriangleFilter>(run, first, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(float_run);
HWY_EXPORT(double_run);

template <>
void settle(const TriangleRun<float>& run, std::size_t first, std::size_t count, Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(float_run)(run, first, count, out);
}
template <>
void settle(const TriangleRun<double>& run, std::size_t first, std::size_t count, Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(double_run)(run, first, count, out);
}

}  // namespace graze::batch
#endif
