// Where nodes and leaves lie in memory.
#pragma once

#include <hwy/base.h>

#include "scene/data.hpp"

namespace graze::scene {

/// Found without branches, for whether a child is a node or a leaf is not predictable; of nothing and of spheres always the
/// same place, anywhere.
template <Real T>
class Places {
 public:
  explicit Places(const Data<T>& data) noexcept
      : first_{bytes(data.nodes), bytes(data.nodes), bytes(data.triangles), bytes(data.nodes)} {}

  /// Asks for a child's memory, for it will be visited soon: in a scene beyond the first caches a tenth of the time. Always
  /// inlined: GCC takes a function that only fetches for one without effect, and drops its calls.
  HWY_INLINE void fetch(Child child) const noexcept {
    const std::size_t part = child.part(), is_leaf = part >> 1;
    const char* const at = first_[part] + strides[part] * child.index();
    constexpr std::size_t line = 64, shortest = sizeof(Node) / line, longest = (sizeof(TriangleBlock<T>) + line - 1) / line;
    for (std::size_t i = 0; i <= shortest; ++i) __builtin_prefetch(at + i * line);
    for (std::size_t i = shortest + 1; i < longest; ++i) __builtin_prefetch(at + i * line * is_leaf);
  }

 private:
  static constexpr int parts = 4;  ///< as Child::part tells
  static constexpr std::size_t strides[parts] = {sizeof(Node), sizeof(Node), sizeof(TriangleBlock<T>), 0};
  const char* first_[parts];

  template <class Elements>
  static const char* bytes(const Elements& elements) noexcept {
    return reinterpret_cast<const char*>(elements.data());
  }
};

}  // namespace graze::scene
