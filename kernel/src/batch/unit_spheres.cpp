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
HWY_INLINE void settle_lanes(const UnitRay<T>& ray, const SphereColumns<T>& spheres, std::size_t first, std::size_t count,
                             Verdicts& out) {
  const Tag<T> d;
  settle<Tag<T>, false, true>(d, Columns<T, 1>{}, spheres, first, count, UnitSpheres<Tag<T>>(d, ray), out);
}
template <class T>
HWY_INLINE std::size_t settle_sure(const UnitRay<T>& ray, const SphereColumns<T>& spheres, std::size_t first, std::size_t words,
                                   std::uint64_t* mask) {
  return UnitSpheres<Tag<T>>(Tag<T>(), ray).settle_words(spheres, first, words, mask);
}

void float_run(const UnitRay<float>& ray, const SphereColumns<float>& spheres, std::size_t first, std::size_t count,
               Verdicts& out) {
  settle_lanes(ray, spheres, first, count, out);
}
void double_run(const UnitRay<double>& ray, const SphereColumns<double>& spheres, std::size_t first, std::size_t count,
                Verdicts& out) {
  settle_lanes(ray, spheres, first, count, out);
}
std::size_t float_words(const UnitRay<float>& ray, const SphereColumns<float>& spheres, std::size_t first, std::size_t words,
                        std::uint64_t* mask) {
  return settle_sure(ray, spheres, first, words, mask);
}
std::size_t double_words(const UnitRay<double>& ray, const SphereColumns<double>& spheres, std::size_t first, std::size_t words,
                         std::uint64_t* mask) {
  return settle_sure(ray, spheres, first, words, mask);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(float_run);
HWY_EXPORT(double_run);
HWY_EXPORT(float_words);
HWY_EXPORT(double_words);

template <>
void settle(const UnitRay<float>& ray, const SphereColumns<float>& spheres, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(float_run)(ray, spheres, first, count, out);
}
template <>
void settle(const UnitRay<double>& ray, const SphereColumns<double>& spheres, std::size_t first, std::size_t count,
            Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(double_run)(ray, spheres, first, count, out);
}
template <>
std::size_t settle_words(const UnitRay<float>& ray, const SphereColumns<float>& spheres, std::size_t first, std::size_t words,
                         std::uint64_t* mask) noexcept {
  return HWY_DYNAMIC_DISPATCH(float_words)(ray, spheres, first, words, mask);
}
template <>
std::size_t settle_words(const UnitRay<double>& ray, const SphereColumns<double>& spheres, std::size_t first, std::size_t words,
                         std::uint64_t* mask) noexcept {
  return HWY_DYNAMIC_DISPATCH(double_words)(ray, spheres, first, words, mask);
}

}  // namespace graze::batch
#endif
