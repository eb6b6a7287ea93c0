// All that a scene holds.
#pragma once

#include <algorithm>
#include <vector>

#include "graze/scene.hpp"
#include "numeric/dyadic.hpp"
#include "scene/node.hpp"
#include "scene/pages.hpp"
#include "scene/triangle_block.hpp"

namespace graze::scene {

/// The parts, their numbering, and where they lie.
template <Real T>
struct Content {
  std::vector<Part<T>> parts;
  std::vector<std::uint32_t> first;  ///< the index of each part's first primitive, and the number of all
  Bounds<T> bounds{};
  numeric::Extent extent;  ///< of all triangles' corners
  Space space;

  [[nodiscard]] std::uint32_t size() const noexcept { return first.empty() ? 0 : first.back(); }
  [[nodiscard]] std::uint32_t part_of(std::uint32_t primitive) const noexcept {
    if (parts.size() == 1) return 0;
    return static_cast<std::uint32_t>(std::upper_bound(first.begin(), first.end(), primitive) - first.begin()) - 1;
  }
  [[nodiscard]] std::uint32_t mask_of(std::uint32_t primitive) const noexcept {
    const Part<T>& part = parts[part_of(primitive)];
    const auto* mesh = std::get_if<Mesh<T>>(&part);
    return mesh != nullptr ? mesh->mask : std::get_if<Spheres<T>>(&part)->mask;
  }
};

/// One of several leaves that hold a triangle.
struct Listing {
  std::uint32_t primitive;
  std::uint32_t node, slot;  ///< the leaf is this child of this node
};

struct Kernels;
/// The hot loops for the best of the SIMD targets that this machine has.
[[nodiscard]] const Kernels& kernels() noexcept;

template <Real T>
struct Hierarchy {
  Box root = Box::empty();
  Pages<Node> nodes;  ///< parents before their children, the root first; none in a scene of nothing
  Pages<TriangleBlock<T>> triangles;
  Pages<SphereBlock<T>> spheres;
  std::vector<Listing> listings;  ///< of the triangles in several leaves, by primitive; none without spatial splits
};

template <Real T>
struct Data : Content<T>, Hierarchy<T> {
  const Kernels* kernels = &scene::kernels();  ///< once a scene, for a query is over before it is found
  BuildOptions options;                        ///< as the scene was built
};

template <Real T>
[[nodiscard]] inline std::size_t size_of(const Part<T>& part) noexcept {
  const auto* mesh = std::get_if<Mesh<T>>(&part);
  return mesh != nullptr ? mesh->triangles.size() : std::get<Spheres<T>>(part).spheres.size();
}

template <Real T>
[[nodiscard]] inline Triangle<T> triangle_of(const Mesh<T>& mesh, std::size_t i) noexcept {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

/// Where a primitive is that is a triangle.
template <Real T>
struct InMesh {
  const Mesh<T>* mesh;
  std::uint32_t part, triangle;

  [[nodiscard]] const Corners& corners() const noexcept { return mesh->triangles[triangle]; }
};
template <Real T>
[[nodiscard]] inline InMesh<T> triangle_at(const Data<T>& data, std::uint32_t primitive) noexcept {
  const std::uint32_t part = data.part_of(primitive);
  return {std::get_if<Mesh<T>>(&data.parts[part]), part, primitive - data.first[part]};
}
/// The primitive, which is a triangle, as it is now.
template <Real T>
[[nodiscard]] inline Triangle<T> triangle_of(const Data<T>& data, std::uint32_t primitive) noexcept {
  const InMesh<T> at = triangle_at(data, primitive);
  return triangle_of(*at.mesh, at.triangle);
}

}  // namespace graze::scene
