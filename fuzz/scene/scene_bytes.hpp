// Scenes as bytes, for fuzzers: every string of bytes is a scene, a ray, and what else is asked.
//
// First: bit 0 double, not float; bit 1 numbers are their bits, not small integers; bit 2 the ray has a range; bit 3 there are
// options, bit 4 the scene is to be closed, bit 5 its points move before it is asked; bits 6 and 7 how often the triangles
// repeat. Then a signed byte, the exponent of two of the integers' unit, eightfold for double. With bit 3 three bytes:
// one whose low bits are ignore_coplanar, cull_back_faces and spatial_splits, leave_out, the mask. Then the ray's numbers, and
// parts until the end: a byte whose bit 0 says spheres, bits 1 to 4 how many points or spheres, bits 5 to 7 the mask (0: all
// bits); the points or spheres; of a mesh a byte that says how many triangles, and three bytes each. A number is a signed byte
// times the unit, or its bits, little-endian. What is missing at the end reads as zero.
#pragma once

#include <cstdint>
#include <span>
#include <variant>

#include "fuzz/scene/draft.hpp"

namespace graze::fuzz {

template <Real T>
struct SceneQuestion {
  SceneDraft<T> draft;  ///< its parts and primitives may be invalid
  Ray<T> ray;           ///< may be invalid
  QueryOptions options;
  bool is_closed = false, is_refitted = false, is_split = false;
};

[[nodiscard]] std::variant<SceneQuestion<float>, SceneQuestion<double>> decode_scene(std::span<const std::uint8_t> bytes);

}  // namespace graze::fuzz
