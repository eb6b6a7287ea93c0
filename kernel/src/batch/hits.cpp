// Decisions: what the lanes leave in doubt goes to the single query, lane by lane.
#include <algorithm>

#include "batch/columns.hpp"
#include "batch/sheared_ray.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::batch {
namespace {

/// The masks of the lanes from `first`, by the verdicts and, in doubt, by the single query.
template <class Rays, class Shapes>
void finish(const Rays& rays, const Shapes& shapes, std::size_t first, std::size_t count, const Verdicts& verdicts,
            std::uint64_t* mask) noexcept {
  for (std::size_t word = 0; 64 * word < count; ++word) {
    const std::uint64_t there = present(count - 64 * word);
    std::uint64_t hit = verdicts.hit[word] & there;
    for_each_bit(verdicts.doubt[word] & there, [&](std::size_t bit) {
      const std::size_t i = first + 64 * word + bit;
      hit |= std::uint64_t(graze::hits(lane(rays, i), lane(shapes, i))) << bit;
    });
    mask[word] = hit;
  }
}

template <class Rays, class Shapes, class Settle>
void decide(const Rays& rays, const Shapes& shapes, std::uint64_t* mask, const Settle& settle_lanes) noexcept {
  const std::size_t n = lanes(rays, shapes);
  Verdicts verdicts;
  for (std::size_t first = 0; first < n; first += run_lanes) {
    const std::size_t count = std::min(run_lanes, n - first);
    settle_lanes(first, count, verdicts);
    finish(rays, shapes, first, count, verdicts, mask + first / 64);
  }
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
  decide(ray, spheres, mask);
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
