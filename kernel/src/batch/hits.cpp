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
template <class Rays, class Shapes, class Settle>
void decide(const Rays& rays, const Shapes& shapes, std::uint64_t* mask, const Settle& settle_lanes) noexcept {
  const std::size_t n = lanes(rays, shapes);
  Verdicts verdicts;
  Doubts<Rays, Shapes> doubts(rays, shapes, mask);
  std::size_t most = run_lanes;
  for (std::size_t first = 0, count = 0; first < n; first += count) {
    count = std::min(most, n - first);
    settle_lanes(first, count, verdicts);
    for (std::size_t word = 0; 64 * word < count; ++word) {
      mask[first / 64 + word] = verdicts.hit[word] & present(count - 64 * word);
    }
    most = has_doubt(verdicts, count) ? doubtful_lanes : run_lanes;
    if (most == run_lanes) continue;
    for (std::size_t word = 0; 64 * word < count; ++word) {
      const std::uint64_t doubt = verdicts.doubt[word] & present(count - 64 * word);
      if (doubt != 0) doubts.add(first / 64 + word, doubt);
    }
  }
  doubts.finish();
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
  // Where there was no doubt, none is looked for: the lanes only tell of a word that all are certain.
  Doubt doubt = Doubt::of_words;
  decide(ray, spheres, mask, [&](std::size_t first, std::size_t count, Verdicts& out) {
    settle(*unit, all, doubt, first, count, out);
    if (doubt == Doubt::of_words && has_doubt(out, count)) settle(*unit, all, Doubt::of_lanes, first, count, out);
    doubt = has_doubt(out, count) ? Doubt::of_lanes : Doubt::of_words;
  });
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
