// Generated closed meshes, made by arithmetic and square roots alone, so that every machine makes the same.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {
namespace {

Vec3<double> unit(const Vec3<double>& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / length, v.y / length, v.z / length};
}

Mesh icosahedron() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  for (const Vec3<double>& p : std::initializer_list<Vec3<double>>{{-1, g, 0},
                                                                   {1, g, 0},
                                                                   {-1, -g, 0},
                                                                   {1, -g, 0},
                                                                   {0, -1, g},
                                                                   {0, 1, g},
                                                                   {0, -1, -g},
                                                                   {0, 1, -g},
                                                                   {g, 0, -1},
                                                                   {g, 0, 1},
                                                                   {-g, 0, -1},
                                                                   {-g, 0, 1}}) {
    mesh.points.push_back(unit(p));
  }
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

/// Each triangle becomes four, by the midpoints of its edges pushed out to the sphere.
void refine(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t i, std::uint32_t j) {
    const auto [entry, is_new] = midpoints.try_emplace(std::minmax(i, j), static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) {
      const Vec3<double> p = mesh.points[i], q = mesh.points[j];
      mesh.points.push_back(unit({p.x + q.x, p.y + q.y, p.z + q.z}));
    }
    return entry->second;
  };
  std::vector<std::array<std::uint32_t, 3>> finer;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(finer);
}

}  // namespace

Mesh icosphere(int levels) {
  Mesh mesh = icosahedron();
  for (int i = 0; i < levels; ++i) refine(mesh);
  mesh.name = "icosphere-" + std::to_string(levels);
  return mesh;
}

Mesh wavy_sphere(int levels) {
  Mesh mesh = icosphere(levels);
  mesh.name = "wavy-sphere-" + std::to_string(levels);
  for (Vec3<double>& p : mesh.points) {
    const double radius = 1 + 0.25 * (3 * p.x * p.y + 2 * p.y * p.z * p.z - p.z * p.x * p.x);
    p = {p.x * radius, p.y * radius, p.z * radius};
  }
  return mesh;
}

}  // namespace graze::fuzz
