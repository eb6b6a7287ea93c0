// Scenes and rays that scene_speed times. Rays are in single precision, so that a double scene gets the same.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fuzz/mesh/mesh.hpp"
#include "fuzz/random.hpp"
#include "graze/scene.hpp"

namespace graze::bench {

inline constexpr std::uint64_t scene_seed = 1;
inline constexpr std::size_t picture_side = 128, rays_a_mix = picture_side * picture_side;

[[nodiscard]] inline Vec3<float> narrowed(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

[[nodiscard]] inline Bounds<double> bounds_of(const fuzz::Mesh& mesh) {
  Bounds<double> b{mesh.points[0], mesh.points[0]};
  for (const Vec3<double>& p : mesh.points) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
  }
  return b;
}

/// From an eye before the bounds, row by row.
[[nodiscard]] inline std::vector<Ray<float>> camera_rays(const Bounds<double>& b) {
  const double size = std::max({b.high.x - b.low.x, b.high.y - b.low.y, b.high.z - b.low.z});
  const Vec3<double> eye{(b.low.x + b.high.x) / 2 + 0.3 * size, (b.low.y + b.high.y) / 2 + 0.2 * size, b.high.z + 1.5 * size};
  std::vector<Ray<float>> rays;
  for (std::size_t i = 0; i < rays_a_mix; ++i) {
    const double x = b.low.x + (b.high.x - b.low.x) * static_cast<double>(i % picture_side) / picture_side;
    const double y = b.low.y + (b.high.y - b.low.y) * static_cast<double>(i / picture_side) / picture_side;
    rays.push_back({narrowed(eye.x, eye.y, eye.z), narrowed(x - eye.x, y - eye.y, (b.low.z + b.high.z) / 2 - eye.z)});
  }
  return rays;
}

/// From any point of the bounds to any other.
[[nodiscard]] inline std::vector<Ray<float>> incoherent_rays(const Bounds<double>& b) {
  const fuzz::Random stream(scene_seed, "incoherent", 0);
  std::vector<Ray<float>> rays;
  for (std::size_t i = 0; i < rays_a_mix; ++i) {
    fuzz::Random random = stream.at(i);
    const auto unit = [&] { return static_cast<double>(random.bits() >> 11) * 0x1p-53; };
    const auto point = [&] {
      Vec3<double> p;
      p.x = b.low.x + (b.high.x - b.low.x) * unit();
      p.y = b.low.y + (b.high.y - b.low.y) * unit();
      p.z = b.low.z + (b.high.z - b.low.z) * unit();
      return p;
    };
    const Vec3<double> from = point(), to = point();
    rays.push_back({narrowed(from.x, from.y, from.z), narrowed(to.x - from.x, to.y - from.y, to.z - from.z)});
  }
  return rays;
}

template <Real T>
[[nodiscard]] std::vector<Ray<T>> converted(const std::vector<Ray<float>>& rays) {
  std::vector<Ray<T>> out;
  for (const auto& [e, d, t_min, t_max] : rays) {
    out.push_back({{T(e.x), T(e.y), T(e.z)}, {T(d.x), T(d.y), T(d.z)}, T(t_min), T(t_max)});
  }
  return out;
}

/// The surface of a block of unit cubes, one in eight of them filled: all corners are small integers, many faces in one plane.
[[nodiscard]] inline fuzz::Mesh cubes(int side) {
  fuzz::Random random(scene_seed, "cubes", 0);
  const auto n = static_cast<std::size_t>(side);
  std::vector<bool> filled(n * n * n);
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = random.one_in(8);
  const auto at = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side) return false;
    return static_cast<bool>(
        filled[(static_cast<std::size_t>(x) * n + static_cast<std::size_t>(y)) * n + static_cast<std::size_t>(z)]);
  };
  fuzz::Mesh mesh;
  mesh.name = "cubes-" + std::to_string(side);
  for (int i = 0; i < 3 * (side + 1) * (side + 1) * (side + 1); ++i) {
    const int axis = i % 3, x = i / 3 / (side + 1) / (side + 1) - 1, y = i / 3 / (side + 1) % (side + 1) - 1,
              z = i / 3 % (side + 1) - 1;
    if (at(x, y, z) == at(x + (axis == 0), y + (axis == 1), z + (axis == 2))) continue;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      double p[3] = {double(x), double(y), double(z)};
      p[axis] += 1;
      p[(axis + 1) % 3] += u;
      p[(axis + 2) % 3] += v;
      mesh.points.push_back({p[0], p[1], p[2]});
    }
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  }
  return mesh;
}

/// From points of the lattice along its lines; and the same turned by the angle sqrt(2) about (1, 1, 1).
struct LatticeRays {
  std::vector<Ray<double>> along, turned;
};
[[nodiscard]] inline LatticeRays lattice_rays(int side) {
  const fuzz::Random stream(scene_seed, "lattice-rays", 0);
  const double cosine = std::cos(std::sqrt(2.0)), sine = std::sin(std::sqrt(2.0)), k = 1 / std::sqrt(3.0);
  LatticeRays rays;
  for (std::size_t i = 0; i < rays_a_mix; ++i) {
    fuzz::Random random = stream.at(i);
    double e[3], d[3] = {0, 0, 0}, turned[3];
    for (double& x : e) x = random.between(0, side);
    d[random.below(3)] = random.sign();
    for (int j = 0; j < 3; ++j) {
      turned[j] = d[j] * cosine + k * (d[(j + 2) % 3] - d[(j + 1) % 3]) * sine + k * k * (d[0] + d[1] + d[2]) * (1 - cosine);
    }
    rays.along.push_back({{e[0], e[1], e[2]}, {d[0], d[1], d[2]}});
    rays.turned.push_back({{e[0], e[1], e[2]}, {turned[0], turned[1], turned[2]}});
  }
  return rays;
}

}  // namespace graze::bench
