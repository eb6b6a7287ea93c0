// The mixes of inputs by name: the same six for spheres and triangles.
#pragma once

#include <array>
#include <string_view>

#include "bench/sphere_mixes.hpp"
#include "bench/triangle_mixes.hpp"

namespace graze::bench {

template <class Query>
struct Mix {
  std::string_view name;   ///< in results
  std::string_view title;  ///< on pages
  std::vector<Query> (*make)(std::size_t n, std::uint64_t seed);
};

template <class Query>
inline constexpr bool is_triangle = requires(Query q) {
  q.triangle;
};

template <Real T>
[[nodiscard]] std::array<Mix<fuzz::RayTriangle<T>>, 6> mixes_of(const fuzz::RayTriangle<T>&) {
  using S = Source<T>;
  return {{
      {"random", "random: all uniform in a cube, few hits", [](auto n, auto seed) { return random_triangles(n, S(seed)); }},
      {"camera", "camera-like: an eye before a wavy mesh", [](auto n, auto seed) { return camera_triangles(n, S(seed)); }},
      {"grazing", "grazing: nearly in the triangle's plane", [](auto n, auto seed) { return grazing_triangles(n, S(seed)); }},
      {"far", "far and small", [](auto n, auto seed) { return far_triangles(n, S(seed)); }},
      {"edges", "edges and corners: on them, or a hair off", [](auto n, auto seed) { return edge_triangles(n, S(seed)); }},
      {"lattice", "degenerate lattice: integers of [-2, 2]", [](auto n, auto seed) { return lattice_triangles(n, S(seed)); }},
  }};
}

template <Real T>
[[nodiscard]] std::array<Mix<fuzz::RaySphere<T>>, 6> mixes_of(const fuzz::RaySphere<T>&) {
  using S = Source<T>;
  return {{
      {"random", "random: all uniform in a cube", [](auto n, auto seed) { return random_spheres(n, S(seed)); }},
      {"camera", "camera-like: an eye before a wall of balls", [](auto n, auto seed) { return camera_spheres(n, S(seed)); }},
      {"grazing", "grazing: by the limb", [](auto n, auto seed) { return grazing_spheres(n, S(seed)); }},
      {"far", "far and small", [](auto n, auto seed) { return far_spheres(n, S(seed)); }},
      {"edges", "tangents, and origins on the sphere or a hair off",
       [](auto n, auto seed) { return edge_spheres(n, S(seed)); }},
      {"lattice", "degenerate lattice: integers of [-2, 2]", [](auto n, auto seed) { return lattice_spheres(n, S(seed)); }},
  }};
}

}  // namespace graze::bench
