// Primitives by their boxes, to be sorted into a hierarchy.
#pragma once

#include <algorithm>
#include <cstring>

#include "scene/data.hpp"
#include "scene/parallel.hpp"

namespace graze::scene {

/// Three floats and one more that is not looked at.
using Four = float __attribute__((vector_size(16)));
using FourIntegers = std::int32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Four lesser(const Four& a, const Four& b) noexcept {
  return a < b ? a : b;
}
[[nodiscard]] inline Four greater(const Four& a, const Four& b) noexcept {
  return a > b ? a : b;
}

/// A primitive, to be sorted.
struct alignas(16) Reference {
  float low[3];
  std::uint32_t index : 31;
  std::uint32_t is_sphere : 1;
  float high[3];
  std::uint32_t unused;

  /// With the index as the fourth.
  [[nodiscard]] Four low_corner() const noexcept {
    Four out;
    std::memcpy(&out, low, sizeof out);
    return out;
  }
  [[nodiscard]] Four high_corner() const noexcept {
    Four out;
    std::memcpy(&out, high, sizeof out);
    return out;
  }
  /// Twice that.
  [[nodiscard]] Four center() const noexcept { return low_corner() + high_corner(); }
  [[nodiscard]] Box box() const noexcept { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

/// A box that grows.
struct Hull {
  Four low = Four{} + 0x1p100F, high = Four{} - 0x1p100F;

  void include(const Four& from, const Four& to) noexcept {
    low = lesser(from, low);
    high = greater(to, high);
  }
  void include(const Hull& other) noexcept { include(other.low, other.high); }
  [[nodiscard]] Box box() const noexcept { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

template <Real T>
[[nodiscard]] Pages<Reference> references_of(const Data<T>& data, Threads threads) {
  Pages<Reference> out(data.size());
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const std::uint32_t first = data.first[p];
    for_ranges(size_of(data.parts[p]), 4096, threads, [&](std::size_t begin, std::size_t end) {
      const auto* mesh = std::get_if<Mesh<T>>(&data.parts[p]);
      for (std::size_t i = begin; i < end; ++i) {
        const Box box = mesh != nullptr ? box_of(data.space, triangle_of(*mesh, i))
                                        : box_of(data.space, std::get<Spheres<T>>(data.parts[p]).spheres[i]);
        Reference& r = out[first + i];
        std::copy_n(box.low, 3, r.low);
        std::copy_n(box.high, 3, r.high);
        r.index = static_cast<std::uint32_t>(first + i);
        r.is_sphere = mesh == nullptr ? 1 : 0;
        r.unused = 0;
      }
    });
  }
  return out;
}

}  // namespace graze::scene
