// Leaves of triangles in SIMD order.
#pragma once

#include <cstdint>

#include "graze/triangle.hpp"
#include "scene/node.hpp"

namespace graze::scene {

/// Lanes that hold nothing come last; their index is no_primitive, and their corners are the first triangle's.
template <Real T>
struct TriangleBlock;

template <>
struct alignas(64) TriangleBlock<float> {
  float corners[3][3][width];  ///< by corner a, b, c, then axis
  std::uint32_t index[width];

  [[nodiscard]] Vec3<float> corner(int c, int i) const noexcept {
    return {corners[c][0][i], corners[c][1][i], corners[c][2][i]};
  }
  [[nodiscard]] Triangle<float> triangle(int i) const noexcept { return {corner(0, i), corner(1, i), corner(2, i)}; }
};

/// Of doubles each point once, however many of the triangles share it: six cache lines, where corners by themselves take ten.
/// Triangles that share nothing come in blocks of at most four.
template <>
struct alignas(32) TriangleBlock<double> {
  static constexpr int most_points = 12;

  double points[3][most_points];  ///< by axis
  std::uint32_t index[width];
  std::uint8_t place[3][width];  ///< of corners a, b, c: which point

  [[nodiscard]] Vec3<double> corner(int c, int i) const noexcept {
    const int p = place[c][i];
    return {points[0][p], points[1][p], points[2][p]};
  }
  [[nodiscard]] Triangle<double> triangle(int i) const noexcept { return {corner(0, i), corner(1, i), corner(2, i)}; }
};

}  // namespace graze::scene
