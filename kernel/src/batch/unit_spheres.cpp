// One ray and spheres in lanes, compiled for each instruction set.
// The order is Highway's: the targets, then this file again for each, then what it includes.
// clang-format off
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/unit_spheres.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep

#include "batch/lanes-inl.hpp"
#include "batch/unit_spheres-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

template <class T>
HWY_INLINE void settle_lanes(const UnitRay<T>& ray, const SphereColumns<T>& spheres, Doubt doubt, std::size_t first,
                             std::size_t count, Verdicts& out) {
  using D = Tag<T>;
  const D d;
  const Columns<T, 1> none{};
  if (doubt == Doubt::of_words) {
    return settle<D, false, true>(d, none, spheres, first, count, UnitSpheres<D, Doubt::of_words>(d, ray), out);
  }
  settle<D, false, true>(d, none, spheres, first, count, UnitSpheres<D, Doubt::of_lanes>(d, ray), out);
}

void float_run(const UnitRay<float>& ray, const SphereColumns<float>& spheres, Doubt doubt, std::size_t first,
               std::size_t count, Verdicts& out) {
  settle_lanes(ray, spheres, doubt, first, count, out);
}
void double_run(const UnitRay<double>& ray, const SphereColumns<double>& spheres, Doubt doubt, std::size_t first,
                std::size_t count, Verdicts& out) {
  settle_lanes(ray, spheres, doubt, first, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(float_run);
HWY_EXPORT(double_run);

template <>
void settle(const UnitRay<float>& ray, const SphereColumns<float>& spheres, Doubt doubt, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(float_run)(ray, spheres, doubt, first, count, out);
}
template <>
void settle(const UnitRay<double>& ray, const SphereColumns<double>& spheres, Doubt doubt, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(double_run)(ray, spheres, doubt, first, count, out);
}

}  // namespace graze::batch
#endif
