// Decisions: what the lanes leave in doubt is gathered and decided after them.
#include <algorithm>

#include "batch/doubts.hpp"
#include "batch/sheared_ray.hpp"
#include "batch/unit_ray.hpp"

namespace graze::batch {
namespace {

/// Runs while there is doubt: as long as the nearest cache holds, for lanes in doubt are read again.
constexpr std::size_t doubtful_lanes = 256;

/// settle_lanes(first, count, verdicts) tells what the lanes know; the masks' other bits are those of the lanes in doubt.
/// settle_words(first, words) tells of how many words all lanes are certain, and has written these; it is asked while there is
/// no doubt.
template <class Rays, class Shapes, class SettleLanes, class SettleWords>
void decide(const Rays& rays, const Shapes& shapes, std::uint64_t* mask, const SettleLanes& settle_lanes,
            const SettleWords& settle_words) noexcept {
  const std::size_t n = lanes(rays, shapes);
  Verdicts verdicts;
  Doubts<Rays, Shapes> doubts(rays, shapes, mask);
  bool has_doubts = false;
  for (std::size_t first = 0, count = 0; first < n; first += count) {
    if (!has_doubts) {
      first += 64 * settle_words(first, (n - first) / 64);
      if (first == n) break;
    }
    count = std::min(has_doubts ? doubtful_lanes : run_lanes, n - first);
    settle_lanes(first, count, verdicts);
    for (std::size_t word = 0; 64 * word < count; ++word) {
      mask[first / 64 + word] = verdicts.hit[word] & present(count - 64 * word);
    }
    has_doubts = has_doubt(verdicts, count);
    if (!has_doubts) continue;
    for (std::size_t word = 0; 64 * word < count; ++word) {
      const std::uint64_t doubt = verdicts.doubt[word] & present(count - 64 * word);
      if (doubt != 0) doubts.add(first / 64 + word, doubt);
    }
  }
  doubts.finish();
}
template <class Rays, class Shapes, class SettleLanes>
void decide(const Rays& rays, const Shapes& shapes, std::uint64_t* mask, const SettleLanes& settle_lanes) noexcept {
  decide(rays, shapes, mask, settle_lanes, [](std::size_t, std::size_t) { return std::size_t(0); });
}

template <class Rays, class Shapes>
void decide(const Rays& rays, const Shapes& shapes, std::uint64_t* mask) noexcept {
  const Run run{columns(rays), columns(shapes), is_array<Rays>, is_array<Shapes>, has_range(rays)};
  decide(rays, shapes, mask, [&](std::size_t first, std::size_t count, Verdicts& out) { settle(run, first, count, out); });
}

}  // namespace

template <Real T>
void hits(const Ray<T>& ray, const TriangleArrays<T>& triangles, std::uint64_t* mask) noexcept {
  const auto sheared = shear(ray);
  if (!sheared) return decide(ray, triangles, mask);
  const TriangleColumns<T> along = columns_along(*sheared, triangles);
  decide(ray, triangles, mask,
         [&](std::size_t first, std::size_t count, Verdicts& out) { settle(*sheared, along, first, count, out); });
}
template <Real T>
void hits(const RayArrays<T>& rays, const Triangle<T>& triangle, std::uint64_t* mask) noexcept {
  decide(rays, triangle, mask);
}
template <Real T>
void hits(const RayArrays<T>& rays, const TriangleArrays<T>& triangles, std::uint64_t* mask) noexcept {
  decide(rays, triangles, mask);
}
template <Real T>
void hits(const Ray<T>& ray, const SphereArrays<T>& spheres, std::uint64_t* mask) noexcept {
  const auto unit = unit_ray(ray);
  if (!unit) return decide(ray, spheres, mask);
  const SphereColumns<T> all = columns(spheres);
  decide(
      ray, spheres, mask, [&](std::size_t first, std::size_t count, Verdicts& out) { settle(*unit, all, first, count, out); },
      [&](std::size_t first, std::size_t words) { return settle_words(*unit, all, first, words, mask + first / 64); });
}
template <Real T>
void hits(const RayArrays<T>& rays, const Sphere<T>& sphere, std::uint64_t* mask) noexcept {
  decide(rays, sphere, mask);
}
template <Real T>
void hits(const RayArrays<T>& rays, const SphereArrays<T>& spheres, std::uint64_t* mask) noexcept {
  decide(rays, spheres, mask);
}

#define GRAZE_INSTANTIATE(T)                                                                  \
  template void hits(const Ray<T>&, const TriangleArrays<T>&, std::uint64_t*) noexcept;       \
  template void hits(const RayArrays<T>&, const Triangle<T>&, std::uint64_t*) noexcept;       \
  template void hits(const RayArrays<T>&, const TriangleArrays<T>&, std::uint64_t*) noexcept; \
  template void hits(const Ray<T>&, const SphereArrays<T>&, std::uint64_t*) noexcept;         \
  template void hits(const RayArrays<T>&, const Sphere<T>&, std::uint64_t*) noexcept;         \
  template void hits(const RayArrays<T>&, const SphereArrays<T>&, std::uint64_t*) noexcept;
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::batch
