// Lanes in doubt that lie on lattices, compiled for each instruction set.
// The order is Highway's: the targets, then this file again for each, then what it includes.
// clang-format off
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/on_lattice.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep

#include <bit>

#include "batch/lanes-inl.hpp"
#include "batch/on_lattice-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

/// The bits of `packed`, the lowest first, at those of `places`.
HWY_INLINE std::uint64_t deposit(std::uint64_t packed, std::uint64_t places) {
#if HWY_TARGET <= HWY_AVX2 && HWY_ARCH_X86_64 && HWY_NATIVE_FMA
  return _pdep_u64(packed, places);
#else
  std::uint64_t out = 0;
  for (; places != 0; places &= places - 1, packed >>= 1) out |= (packed & 1) << std::countr_zero(places);
  return out;
#endif
}

/// Gives the words the verdicts on their first `count` lanes.
HWY_INLINE std::size_t deposit_all(const Verdicts& verdicts, std::size_t count, DoubtWord* words) {
  std::size_t k = 0;
  for (std::size_t at = 0; at < count; ++k) {
    const std::size_t n = static_cast<std::size_t>(std::popcount(words[k].doubt)), left = count - at;
    const std::uint64_t places = n <= left ? words[k].doubt : deposit(present(left), words[k].doubt);
    words[k].hit = deposit(verdicts.hit[0] >> at, places);
    words[k].unknown = deposit(verdicts.doubt[0] >> at, places);
    at += n;
  }
  return k;
}

/// Products are exact by multiply-adds that round once; without those all stays in doubt.
template <template <class, bool> class FilterOf, int m>
HWY_INLINE std::size_t settle_exactly([[maybe_unused]] const Run<double, m>& run, std::size_t count, DoubtWord* words) {
  Verdicts out;
#if HWY_NATIVE_FMA
  const Tag<double> d;
  const FilterOf<Tag<double>, false> filter(run);
  if (run.has_many_rays) {
    settle<Tag<double>, true, true>(d, run.rays, run.shapes, 0, count, filter, out);
  } else {
    settle<Tag<double>, false, true>(d, run.rays, run.shapes, 0, count, filter, out);
  }
#else
  out.hit[0] = 0, out.doubt[0] = ~std::uint64_t(0);
#endif
  return deposit_all(out, count, words);
}

std::size_t triangle_run(const TriangleRun<double>& run, std::size_t count, DoubtWord* words) {
  return settle_exactly<TrianglesOnLattice>(run, count, words);
}
std::size_t sphere_run(const SphereRun<double>& run, std::size_t count, DoubtWord* words) {
  return settle_exactly<SpheresOnLattice>(run, count, words);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::batch {

HWY_EXPORT(triangle_run);
HWY_EXPORT(sphere_run);

std::size_t settle_on_lattice(const TriangleRun<double>& run, std::size_t count, DoubtWord* words) noexcept {
  return HWY_DYNAMIC_DISPATCH(triangle_run)(run, count, words);
}
std::size_t settle_on_lattice(const SphereRun<double>& run, std::size_t count, DoubtWord* words) noexcept {
  return HWY_DYNAMIC_DISPATCH(sphere_run)(run, count, words);
}

}  // namespace graze::batch
#endif
