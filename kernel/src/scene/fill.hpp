// Blocks of shapes from the parts, as they are now.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "scene/data.hpp"

namespace graze::scene {

/// Which of the points of some triangles are one: for each corner, by triangle, the place of its point among the distinct ones.
struct SharedPoints {
  int size = 0;
  std::array<std::uint8_t, 3 * width> places;
};

/// Of at most a block's triangles; key(i, c) tells points apart, and its hash is a good one in its highest bits.
template <class Key>
[[nodiscard]] inline SharedPoints shared_points(int triangles, Key key) noexcept {
  constexpr std::size_t slots = 32;
  static_assert(3 * width < slots);
  std::array<std::uint8_t, slots> place_of{};  // one more than that, 0 for none
  std::array<decltype(key(0, 0)), 3 * width + 1> seen;
  SharedPoints out;
  for (int i = 0; i < triangles; ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto one = key(i, c);
      std::size_t slot = one.hash() >> 59;
      while (place_of[slot] != 0 && !(seen[place_of[slot]] == one)) slot = (slot + 1) % slots;
      if (place_of[slot] == 0) {
        place_of[slot] = static_cast<std::uint8_t>(++out.size);
        seen[place_of[slot]] = one;
      }
      out.places[static_cast<std::size_t>(3 * i + c)] = static_cast<std::uint8_t>(place_of[slot] - 1);
    }
  }
  return out;
}

/// A point by its number in a part.
struct PointNumber {
  std::uint64_t part_and_number;

  [[nodiscard]] std::uint64_t hash() const noexcept { return part_and_number * 0x9e3779b97f4a7c15U; }
  bool operator==(const PointNumber&) const = default;
};
/// A point by its coordinates' bits: where denormals are zero, numbers lie.
struct PointBits {
  std::array<std::uint64_t, 3> bits;

  [[nodiscard]] std::uint64_t hash() const noexcept {
    return bits[0] * 0x9e3779b97f4a7c15U + bits[1] * 0xc2b2ae3d27d4eb4fU + bits[2] * 0x165667b19e3779f9U;
  }
  bool operator==(const PointBits&) const = default;
};

/// Triangles for a block, at most its lanes.
struct BlockTriangles {
  int size;
  std::array<InMesh<double>, width> at;

  template <class Index>
  BlockTriangles(const Data<double>& data, int n, Index index) noexcept : size(n) {
    for (int i = 0; i < size; ++i) at[static_cast<std::size_t>(i)] = triangle_at(data, index(i));
  }
  [[nodiscard]] std::uint32_t part(int i) const noexcept { return at[static_cast<std::size_t>(i)].part; }
  [[nodiscard]] std::uint32_t number(int i, int c) const noexcept {
    return at[static_cast<std::size_t>(i)].corners()[static_cast<std::size_t>(c)];
  }
  [[nodiscard]] const Vec3<double>& point(int i, int c) const noexcept {
    return at[static_cast<std::size_t>(i)].mesh->points[number(i, c)];
  }
  /// By the points' numbers if that will do, by their coordinates if not: triangles may have points of their own and share
  /// them all the same.
  [[nodiscard]] SharedPoints shared() const noexcept {
    const SharedPoints by_number =
        shared_points(size, [this](int i, int c) { return PointNumber{std::uint64_t(part(i)) << 32 | number(i, c)}; });
    if (by_number.size <= TriangleBlock<double>::most_points) return by_number;
    return shared_points(size,
                         [this](int i, int c) { return PointBits{std::bit_cast<std::array<std::uint64_t, 3>>(point(i, c))}; });
  }
};

/// Whether so many triangles, at most a block's lanes, fit into a block; index(i) is the i-th's primitive.
template <class Index>
[[nodiscard]] bool fits(const Data<float>&, int, Index) noexcept {
  return true;
}
template <class Index>
[[nodiscard]] bool fits(const Data<double>& data, int size, Index index) noexcept {
  constexpr int most = TriangleBlock<double>::most_points;
  return 3 * size <= most || BlockTriangles(data, size, index).shared().size <= most;
}

/// Fills a block with `size` shapes, if they fit. Empty lanes repeat the first shape, so that they hold ordinary numbers.
template <class Index>
void fill(const Data<float>& data, TriangleBlock<float>& block, int size, Index index) noexcept {
  for (int i = 0; i < width; ++i) {
    const std::uint32_t primitive = index(i < size ? i : 0);
    const Triangle<float> t = triangle_of(data, primitive);
    int c = 0;
    for (const Vec3<float>& p : {t.a, t.b, t.c}) {
      block.corners[c][0][i] = p.x;
      block.corners[c][1][i] = p.y;
      block.corners[c++][2][i] = p.z;
    }
    block.index[i] = i < size ? primitive : no_primitive;
  }
}
template <class Index>
void fill(const Data<double>& data, TriangleBlock<double>& block, int size, Index index) noexcept {
  const BlockTriangles triangles(data, size, index);
  const SharedPoints points = triangles.shared();
  const std::uint8_t* place = points.places.data();
  for (int i = 0; i < size; ++i) {
    block.index[i] = index(i);
    for (int c = 0; c < 3; ++c) {
      const Vec3<double>& p = triangles.point(i, c);
      block.points[0][*place] = p.x;
      block.points[1][*place] = p.y;
      block.points[2][*place] = p.z;
      block.place[c][i] = *place++;
    }
  }
  for (int i = size; i < width; ++i) {
    block.index[i] = no_primitive;
    for (auto& places : block.place) places[i] = places[0];
  }
  // What no corner names is read all the same.
  for (auto& axis : block.points) std::fill(axis + points.size, std::end(axis), axis[0]);
}
template <Real T, class Index>
void fill(const Data<T>& data, SphereBlock<T>& block, int size, Index index) noexcept {
  for (int i = 0; i < width; ++i) {
    const std::uint32_t primitive = index(i < size ? i : 0), part = data.part_of(primitive);
    block.set(i, std::get_if<Spheres<T>>(&data.parts[part])->spheres[primitive - data.first[part]],
              i < size ? primitive : no_primitive);
  }
}

}  // namespace graze::scene
