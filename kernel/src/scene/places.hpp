// Where nodes and leaves lie in memory.
#pragma once

#include "scene/data.hpp"

namespace graze::scene {

/// Found without branches: whether a child is a node or a leaf is not predictable.
template <Real T>
class Places {
 public:
  explicit Places(const Data<T>& data) noexcept
      : first_{bytes(data.nodes), bytes(data.nodes), bytes(data.triangles), bytes(data.nodes)} {}

  /// Of nothing and of spheres always the same, anywhere.
  [[nodiscard]] const char* of(Child child) const noexcept {
    return first_[child.part()] + strides[child.part()] * child.index();
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
