// Lanes in doubt that lie on lattices, compiled for each instruction set.
// The order is Highway's: the targets, then this file again for each, then what it includes.
// clang-format off
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/on_lattice.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep

#include "batch/lanes-inl.hpp"
#include "batch/on_lattice-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

/// Products are exact by multiply-adds that round once; without those all stays in doubt.
template <template <class, bool> class FilterOf, int m>
HWY_INLINE void settle_exactly([[maybe_unused]] const Run<double, m>& run, std::size_t count, Verdicts& out) {
#if HWY_NATIVE_FMA
  const Tag<double> d;
  const FilterOf<Tag<double>, false> filter;
  if (!run.has_many_rays) return settle<Tag<double>, false, true>(d, run.rays, run.shapes, 0, count, filter, out);
  settle<Tag<double>, true, true>(d, run.rays, run.shapes, 0, count, filter, out);
#else
  for (std::size_t word = 0; 64 * word < count; ++word) out.hit[word] = 0, out.doubt[word] = ~std::uint64_t(0);
#endif
}

void triangle_run(const TriangleRun<double>& run, std::size_t count, Verdicts& out) {
  settle_exactly<TrianglesOnLattice>(run, count, out);
}
void sphere_run(const SphereRun<double>& run, std::size_t count, Verdicts& out) {
  settle_exactly<SpheresOnLattice>(run, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(triangle_run);
HWY_EXPORT(sphere_run);

void settle_on_lattice(const TriangleRun<double>& run, std::size_t count, Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(triangle_run)(run, count, out);
}
void settle_on_lattice(const SphereRun<double>& run, std::size_t count, Verdicts& out) noexcept {
  HWY_DYNAMIC_DISPATCH(sphere_run)(run, count, out);
}

}  // namespace graze::batch
#endif
