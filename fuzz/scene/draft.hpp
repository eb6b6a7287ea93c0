// Generated scenes that are hard for a hierarchy and for the order of hits, and rays at what is hard in them.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/random.hpp"
#include "graze/scene.hpp"

namespace graze::fuzz {

/// A scene as a list of parts, and each primitive by itself, by its index.
template <Real T>
struct SceneDraft {
  struct Primitive {
    Shape shape = Shape::none;
    Triangle<T> triangle{};
    Sphere<T> sphere{};
    std::uint32_t mask = 0;
  };
  std::string_view family;
  std::vector<Part<T>> parts;
  std::vector<Primitive> primitives;
  double unit = 1;  ///< the power of two that all lengths were multiplied by
};

/// Any of the families: random, lattice, slivers, spheres, mixed, extremes, spread, far, same, degenerate, few.
template <Real T>
[[nodiscard]] SceneDraft<T> draft_scene(Random& random);

/// A valid ray, mostly at a corner, an edge or a tangent of the scene.
template <Real T>
[[nodiscard]] Ray<T> draft_ray(const SceneDraft<T>& scene, Random& random);

/// Mostly no options at all.
template <Real T>
[[nodiscard]] QueryOptions draft_options(const SceneDraft<T>& scene, Random& random);

}  // namespace graze::fuzz
