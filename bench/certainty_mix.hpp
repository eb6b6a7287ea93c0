// Inputs of which a share is degenerate: what certainty costs depends on that share alone.
#pragma once

#include <array>

#include "bench/mixes.hpp"

namespace graze::bench {

inline constexpr std::array degenerate_percents{0, 1, 2, 5, 10, 20, 35, 50, 75, 100};

/// Ordinary: aimed into a random triangle. Degenerate: through an edge or a corner of an integer one, exactly.
[[nodiscard]] inline Triangles<double> certainty_mix(const fuzz::RayTriangle<double>&, std::size_t n, int percent,
                                                     std::uint64_t seed) {
  Source<double> s(seed);
  const Triangles<double> degenerate = boundary_triangles<double>(n, 1 << 24, s);
  Triangles<double> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Triangle<double> t{s.point(), s.point(), s.point()};
    const Vec3<double> e = s.point(), p = inner_point(s, t);
    const bool is_degenerate = s.below(100) < static_cast<std::uint64_t>(percent);
    mix.push_back(is_degenerate ? degenerate[i] : fuzz::RayTriangle<double>{{e, difference(p, e)}, t});
  }
  return mix;
}

/// Ordinary: aimed into a random sphere. Degenerate: an exact integer tangent.
[[nodiscard]] inline Spheres<double> certainty_mix(const fuzz::RaySphere<double>&, std::size_t n, int percent,
                                                   std::uint64_t seed) {
  Source<double> s(seed);
  const Spheres<double> degenerate = tangent_spheres<double>(n, 2048, s);
  Spheres<double> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<double> e = s.point(), c = s.point(), p = s.point();
    const double r = s.fraction() / 2;
    const bool is_degenerate = s.below(100) < static_cast<std::uint64_t>(percent);
    const Vec3<double> target = combination(c, r / 2, p, 0.0, p);
    mix.push_back(is_degenerate ? degenerate[i] : fuzz::RaySphere<double>{{e, difference(target, e)}, {c, r}});
  }
  return mix;
}

/// Inside the face, but t = 1 + 2^-53, halfway between two doubles: what the midpoint test is for.
[[nodiscard]] inline Triangles<double> tie_triangles(std::size_t n, std::uint64_t seed) {
  Source<double> s(seed);
  Triangles<double> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<double> a = s.point(), b = s.point(), c = s.point();
    const Triangle<double> t{{a.x - 9, a.y - 9, 0x1p-53}, {b.x + 9, b.y - 9, 0x1p-53}, {c.x, c.y + 9, 0x1p-53}};
    Vec3<double> e = s.point(), d = s.point();
    e.z = -1, d.z = 1;
    mix.push_back({{e, d}, t});
  }
  return mix;
}

}  // namespace graze::bench
