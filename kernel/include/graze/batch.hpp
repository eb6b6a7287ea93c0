// Many queries at once, in SIMD: one ray against arrays of shapes, arrays of rays against one shape, and pairs. The library
// graze::batch, which needs Highway; the widest instructions of the processor are chosen at run time.
//
// Every lane's answer is the single query's (triangle.hpp, sphere.hpp), bit for bit, whatever its neighbours and the
// instructions: a filter in lanes only decides what its error bounds let it, and leaves the rest to the single query. So what
// those headers say of rounding modes, flush-to-zero, denormals-are-zero and traps holds here too.
//
// Arrays are read and written in place, at any alignment and length, 0 included; nothing is allocated, thrown or kept. Outputs
// may not overlap inputs. Invalid lanes are answered as the single query does.
#pragma once

#include <cstddef>
#include <cstdint>

#include "graze/answer.hpp"
#include "graze/numeric/platform.hpp"

namespace graze::batch {

/// Points or directions as three arrays.
template <Real T>
struct Vec3Arrays {
  const T* x = nullptr;
  const T* y = nullptr;
  const T* z = nullptr;
};

/// `t_min` and `t_max` are both given, or both null for 0 <= t without upper end.
template <Real T>
struct RayArrays {
  Vec3Arrays<T> origin, direction;
  std::size_t size = 0;
  const T* t_min = nullptr;
  const T* t_max = nullptr;
};

template <Real T>
struct TriangleArrays {
  Vec3Arrays<T> a, b, c;
  std::size_t size = 0;
};

template <Real T>
struct SphereArrays {
  Vec3Arrays<T> center;
  const T* radius = nullptr;
  std::size_t size = 0;
};

/// How many words a mask of n bits takes.
[[nodiscard]] constexpr std::size_t mask_words(std::size_t n) noexcept {
  return n / 64 + (n % 64 != 0 ? 1 : 0);
}

/// Decisions: bit i % 64 of mask[i / 64] is `hits` of lane i; the last word's bits past the end are 0. Pairs are as many as the
/// shorter side has. `mask` has mask_words(lanes) words.
template <Real T>
void hits(const Ray<T>& ray, const TriangleArrays<T>& triangles, std::uint64_t* mask) noexcept;
template <Real T>
void hits(const RayArrays<T>& rays, const Triangle<T>& triangle, std::uint64_t* mask) noexcept;
template <Real T>
void hits(const RayArrays<T>& rays, const TriangleArrays<T>& triangles, std::uint64_t* mask) noexcept;
template <Real T>
void hits(const Ray<T>& ray, const SphereArrays<T>& spheres, std::uint64_t* mask) noexcept;
template <Real T>
void hits(const RayArrays<T>& rays, const Sphere<T>& sphere, std::uint64_t* mask) noexcept;
template <Real T>
void hits(const RayArrays<T>& rays, const SphereArrays<T>& spheres, std::uint64_t* mask) noexcept;

/// Where whole answers go: one array a field of TriangleHit; a null one is not wanted.
template <Real T>
struct TriangleHitArrays {
  Status* status = nullptr;
  TriangleKind* kind = nullptr;
  Facing* facing = nullptr;
  T* t = nullptr;
  T* t_end = nullptr;
  T* u = nullptr;
  T* v = nullptr;
};

/// As above, of SphereHit: `first` is t[0], `second` is t[1].
template <Real T>
struct SphereHitArrays {
  Status* status = nullptr;
  SphereKind* kind = nullptr;
  Root* root = nullptr;
  OriginSide* origin = nullptr;
  T* first = nullptr;
  T* second = nullptr;
};

/// Whole answers: element i of each array of `out` is that field of `intersect` of lane i.
template <Real T>
void intersect(const Ray<T>& ray, const TriangleArrays<T>& triangles, const TriangleHitArrays<T>& out) noexcept;
template <Real T>
void intersect(const RayArrays<T>& rays, const Triangle<T>& triangle, const TriangleHitArrays<T>& out) noexcept;
template <Real T>
void intersect(const RayArrays<T>& rays, const TriangleArrays<T>& triangles, const TriangleHitArrays<T>& out) noexcept;
template <Real T>
void intersect(const Ray<T>& ray, const SphereArrays<T>& spheres, const SphereHitArrays<T>& out) noexcept;
template <Real T>
void intersect(const RayArrays<T>& rays, const Sphere<T>& sphere, const SphereHitArrays<T>& out) noexcept;
template <Real T>
void intersect(const RayArrays<T>& rays, const SphereArrays<T>& spheres, const SphereHitArrays<T>& out) noexcept;

/// The hit of least exact t, and of equal t the one of the lowest index; index = size where nothing is hit. An invalid ray hits
/// nothing, and `hit` tells its status; an invalid shape is not hit.
template <class Hit>
struct Nearest {
  std::size_t index = 0;
  Hit hit;
};

/// The ray's nearest hit. A hit's t is its first value.
template <Real T>
[[nodiscard]] Nearest<TriangleHit<T>> nearest(const Ray<T>& ray, const TriangleArrays<T>& triangles) noexcept;
template <Real T>
[[nodiscard]] Nearest<SphereHit<T>> nearest(const Ray<T>& ray, const SphereArrays<T>& spheres) noexcept;

}  // namespace graze::batch
