// What a scene is asked, and what it answers.
#pragma once

#include <cstdint>

#include "graze/answer.hpp"

namespace graze {

inline constexpr std::uint32_t no_primitive = ~std::uint32_t(0);

enum class Shape : std::uint8_t { none, triangle, sphere };

/// One primitive that the ray meets. Its first value, by which hits are ordered, is `triangle.t` or `sphere.t[0]`; the order is
/// that of the exact values.
template <Real T>
struct SceneHit {
  Status status = Status::ok;  ///< of the ray; unless it is ok, nothing else has a meaning
  Shape shape = Shape::none;   ///< none for a miss
  std::uint32_t index = no_primitive;
  TriangleHit<T> triangle{};  ///< the whole answer where `shape` is triangle
  SphereHit<T> sphere{};      ///< the whole answer where `shape` is sphere

  [[nodiscard]] bool is_hit() const noexcept { return shape != Shape::none; }
  bool operator==(const SceneHit&) const = default;
};

struct QueryOptions {
  bool ignore_coplanar = false;  ///< triangles in whose plane the ray runs (kind coplanar) are not there
  bool cull_back_faces = false;  ///< triangles that the ray meets from the back are not there; those without a side are
  std::uint32_t leave_out = no_primitive;  ///< this primitive is not there
  std::uint32_t mask = ~std::uint32_t(0);  ///< parts whose mask shares no bit with this are not there
};

/// What a query did. Added to, never reset.
struct Statistics {
  std::uint64_t nodes = 0;            ///< inner nodes whose children's boxes were tested
  std::uint64_t leaves = 0;           ///< leaves visited
  std::uint64_t triangle_tests = 0;   ///< triangles given to the filter
  std::uint64_t sphere_tests = 0;     ///< spheres given to the filter
  std::uint64_t error_bounds = 0;     ///< of these tests, those that needed an error bound
  std::uint64_t filter_misses = 0;    ///< primitives that the filter rejected for certain
  std::uint64_t filter_hits = 0;      ///< primitives that the filter accepted for certain
  std::uint64_t exact_decisions = 0;  ///< primitives that the exact stage decided
  std::uint64_t exact_orders = 0;     ///< pairs of hits that the exact stage put in order
  std::uint64_t roundings = 0;        ///< hits whose numbers were rounded

  Statistics& operator+=(const Statistics& other) noexcept {
    nodes += other.nodes;
    leaves += other.leaves;
    triangle_tests += other.triangle_tests;
    sphere_tests += other.sphere_tests;
    error_bounds += other.error_bounds;
    filter_misses += other.filter_misses;
    filter_hits += other.filter_hits;
    exact_decisions += other.exact_decisions;
    exact_orders += other.exact_orders;
    roundings += other.roundings;
    return *this;
  }
  bool operator==(const Statistics&) const = default;
};

/// Where a point lies against the closed surface that a scene is.
enum class Place : std::uint8_t {
  unknown,   ///< the point is not finite, or the scene was not built closed
  inside,    ///< a way out crosses the surface an odd number of times
  outside,   ///< an even number of times
  boundary,  ///< the point lies on a primitive
};

/// Where batches run.
enum class Threads : std::uint8_t {
  all,   ///< on oneTBB, where the library was built with it
  mine,  ///< on the caller's thread alone
};

}  // namespace graze
