// Whole answers: certain misses are written in bulk, all others come from the single query, lane by lane.
#include <algorithm>

#include "batch/columns.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::batch {
namespace {

/// Sets `count` elements from `first`, where the array is wanted.
template <class T>
void fill(T* array, std::size_t first, std::size_t count, T value) noexcept {
  if (array != nullptr) std::fill_n(array + first, count, value);
}
template <class T>
void set(T* array, std::size_t i, T value) noexcept {
  if (array != nullptr) array[i] = value;
}

template <Real T>
void write(const TriangleHitArrays<T>& out, std::size_t i, const TriangleHit<T>& hit) noexcept {
  set(out.status, i, hit.status);
  set(out.kind, i, hit.kind);
  set(out.facing, i, hit.facing);
  set(out.t, i, hit.t);
  set(out.t_end, i, hit.t_end);
  set(out.u, i, hit.u);
  set(out.v, i, hit.v);
}
template <Real T>
void write(const SphereHitArrays<T>& out, std::size_t i, const SphereHit<T>& hit) noexcept {
  set(out.status, i, hit.status);
  set(out.kind, i, hit.kind);
  set(out.root, i, hit.root);
  set(out.origin, i, hit.origin);
  set(out.first, i, hit.t[0]);
  set(out.second, i, hit.t[1]);
}

/// Misses, whose sides are given by the bits.
template <Real T>
void write_misses(const TriangleHitArrays<T>& out, std::size_t first, std::size_t count, std::uint64_t front) noexcept {
  const TriangleHit<T> miss;
  fill(out.status, first, count, miss.status);
  fill(out.kind, first, count, miss.kind);
  if (out.facing != nullptr) {
    for (std::size_t i = 0; i < count; ++i) out.facing[first + i] = ((front >> i) & 1) != 0 ? Facing::front : Facing::back;
  }
  for (T* number : {out.t, out.t_end, out.u, out.v}) fill(number, first, count, T(0));
}
template <Real T>
void write_misses(const SphereHitArrays<T>& out, std::size_t first, std::size_t count, std::uint64_t inside) noexcept {
  const SphereHit<T> miss;
  fill(out.status, first, count, miss.status);
  fill(out.kind, first, count, miss.kind);
  fill(out.root, first, count, miss.root);
  if (out.origin != nullptr) {
    for (std::size_t i = 0; i < count; ++i) {
      out.origin[first + i] = ((inside >> i) & 1) != 0 ? OriginSide::inside : OriginSide::outside;
    }
  }
  for (T* number : {out.first, out.second}) fill(number, first, count, T(0));
}

template <class Rays, class Shapes, class Out>
void answer(const Rays& rays, const Shapes& shapes, const Out& out) noexcept {
  const Run run{columns(rays), columns(shapes), is_array<Rays>, is_array<Shapes>, has_range(rays)};
  const std::size_t n = lanes(rays, shapes);
  Verdicts verdicts;
  for (std::size_t first = 0; first < n; first += run_lanes) {
    const std::size_t count = std::min(run_lanes, n - first);
    settle(run, first, count, verdicts);
    for (std::size_t word = 0; 64 * word < count; ++word) {
      const std::size_t at = first + 64 * word, left = std::min<std::size_t>(64, count - 64 * word);
      write_misses(out, at, left, verdicts.side[word]);
      for_each_bit((verdicts.hit[word] | verdicts.doubt[word]) & present(left), [&](std::size_t bit) {
        write(out, at + bit, graze::intersect(lane(rays, at + bit), lane(shapes, at + bit)));
      });
    }
  }
}

}  // namespace

template <Real T>
void intersect(const Ray<T>& ray, const TriangleArrays<T>& triangles, const TriangleHitArrays<T>& out) noexcept {
  answer(ray, triangles, out);
}
template <Real T>
void intersect(const RayArrays<T>& rays, const Triangle<T>& triangle, const TriangleHitArrays<T>& out) noexcept {
  answer(rays, triangle, out);
}
template <Real T>
void intersect(const RayArrays<T>& rays, const TriangleArrays<T>& triangles, const TriangleHitArrays<T>& out) noexcept {
  answer(rays, triangles, out);
}
template <Real T>
void intersect(const Ray<T>& ray, const SphereArrays<T>& spheres, const SphereHitArrays<T>& out) noexcept {
  answer(ray, spheres, out);
}
template <Real T>
void intersect(const RayArrays<T>& rays, const Sphere<T>& sphere, const SphereHitArrays<T>& out) noexcept {
  answer(rays, sphere, out);
}
template <Real T>
void intersect(const RayArrays<T>& rays, const SphereArrays<T>& spheres, const SphereHitArrays<T>& out) noexcept {
  answer(rays, spheres, out);
}

#define GRAZE_INSTANTIATE(T)                                                                                    \
  template void intersect(const Ray<T>&, const TriangleArrays<T>&, const TriangleHitArrays<T>&) noexcept;       \
  template void intersect(const RayArrays<T>&, const Triangle<T>&, const TriangleHitArrays<T>&) noexcept;       \
  template void intersect(const RayArrays<T>&, const TriangleArrays<T>&, const TriangleHitArrays<T>&) noexcept; \
  template void intersect(const Ray<T>&, const SphereArrays<T>&, const SphereHitArrays<T>&) noexcept;           \
  template void intersect(const RayArrays<T>&, const Sphere<T>&, const SphereHitArrays<T>&) noexcept;           \
  template void intersect(const RayArrays<T>&, const SphereArrays<T>&, const SphereHitArrays<T>&) noexcept;
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::batch
