// The hierarchy's parts: inner nodes of eight children, leaves of up to eight spheres in SIMD order.
#pragma once

#include <cstdint>

#include "graze/scene/query.hpp"
#include "scene/space.hpp"

namespace graze::scene {

inline constexpr int width = 8;
/// Levels of the hierarchy, at most; see divide.cpp.
inline constexpr int deepest = 100;

/// A child: an inner node, or a block of triangles or of spheres; or nothing, whose box nothing meets but a blind ray.
class Child {
 public:
  [[nodiscard]] static constexpr Child node(std::uint32_t i) noexcept { return Child(i); }
  [[nodiscard]] static constexpr Child triangles(std::uint32_t i) noexcept { return Child(i | leaf); }
  [[nodiscard]] static constexpr Child spheres(std::uint32_t i) noexcept { return Child(i | leaf | sphere); }
  [[nodiscard]] static constexpr Child nothing() noexcept { return Child(~std::uint32_t(0)); }
  /// From a vector of children.
  [[nodiscard]] static constexpr Child from_bits(std::int32_t bits) noexcept { return Child(static_cast<std::uint32_t>(bits)); }

  /// Not initialised, for stacks of many.
  Child() noexcept = default;
  [[nodiscard]] constexpr bool is_nothing() const noexcept { return bits_ == ~std::uint32_t(0); }
  [[nodiscard]] constexpr bool is_leaf() const noexcept { return (bits_ & leaf) != 0; }
  [[nodiscard]] constexpr bool is_spheres() const noexcept { return (bits_ & sphere) != 0; }
  /// 0 for a node, of which there are at most 2^30, 2 for triangles, 3 for spheres or nothing.
  [[nodiscard]] constexpr unsigned part() const noexcept { return bits_ >> 30; }
  /// Of the node or the block.
  [[nodiscard]] constexpr std::uint32_t index() const noexcept { return bits_ & ~(leaf | sphere); }

 private:
  static constexpr std::uint32_t leaf = std::uint32_t(1) << 31, sphere = std::uint32_t(1) << 30;
  explicit constexpr Child(std::uint32_t bits) noexcept : bits_(bits) {}
  std::uint32_t bits_;
};

/// bounds[0] are the low, bounds[1] the high ones; by axis, then child.
struct alignas(32) Node {
  float bounds[2][3][width];
  Child children[width];

  void set(int i, const Box& box, Child child) noexcept {
    for (int k = 0; k < 3; ++k) {
      bounds[0][k][i] = box.low[k];
      bounds[1][k][i] = box.high[k];
    }
    children[i] = child;
  }
  /// All bounds, row after row.
  [[nodiscard]] const float* rows() const noexcept { return &bounds[0][0][0]; }
  [[nodiscard]] Box box(int i) const noexcept {
    return {{bounds[0][0][i], bounds[0][1][i], bounds[0][2][i]}, {bounds[1][0][i], bounds[1][1][i], bounds[1][2][i]}};
  }
};

/// Lanes that hold nothing come last; their index is no_primitive.
template <Real T>
struct alignas(64) SphereBlock {
  T center[3][width];
  T radius[width];
  std::uint32_t index[width];

  [[nodiscard]] Sphere<T> sphere(int i) const noexcept { return {{center[0][i], center[1][i], center[2][i]}, radius[i]}; }
  void set(int i, const Sphere<T>& s, std::uint32_t primitive) noexcept {
    center[0][i] = s.center.x;
    center[1][i] = s.center.y;
    center[2][i] = s.center.z;
    radius[i] = s.radius;
    index[i] = primitive;
  }
};

}  // namespace graze::scene
