// Rays and triangles that queries are timed on.
#pragma once

#include <vector>

#include "bench/source.hpp"
#include "fuzz/case.hpp"

namespace graze::bench {

template <Real T>
using Triangles = std::vector<fuzz::RayTriangle<T>>;

/// A point a + u (b - a) + v (c - a) for random u, v, rounded.
template <Real T>
Vec3<T> inner_point(Source<T>& s, const Triangle<T>& t) {
  T u = s.fraction(), v = s.fraction();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return combination(t.a, u, difference(t.b, t.a), v, difference(t.c, t.a));
}

/// Everything uniform in the cube [-1, 1]^3: few hits.
template <Real T>
Triangles<T> random_triangles(std::size_t n, Source<T> s = Source<T>()) {
  Triangles<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), a = s.point(), b = s.point(), c = s.point();
    mix.push_back({{e, d}, {a, b, c}});
  }
  return mix;
}

/// An eye before a wavy square of 64 x 64 cells, seen through pixels; each ray with a triangle of the cell under its pixel:
/// about half are hit, their neighbours are missed closely.
template <Real T>
Triangles<T> camera_triangles(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int cells = 64;
  const auto corner = [](int i, int j) {
    const double x = 2.0 * i / cells - 1, y = 2.0 * j / cells - 1;
    return Vec3<T>{T(x), T(y), T(0.1 * std::sin(7 * x + 1) * std::cos(5 * y))};
  };
  const Vec3<T> eye{T(0.3), T(-0.4), T(3)};
  Triangles<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const int x = static_cast<int>(s.below(cells)), y = static_cast<int>(s.below(cells));
    const T px = (T(x) + s.fraction()) * 2 / cells - 1, py = (T(y) + s.fraction()) * 2 / cells - 1;
    const bool upper = s.coin();
    const Vec3<T> a = corner(x, y), b = corner(x + 1, y), c = corner(x, y + 1), d = corner(x + 1, y + 1);
    mix.push_back({{eye, unit(difference(Vec3<T>{px, py, T(0)}, eye))}, upper ? Triangle<T>{d, c, b} : Triangle<T>{a, b, c}});
  }
  return mix;
}

/// Aimed at the face at an angle of 2^-5 ... 2^-(digits - 8) to its plane.
template <Real T>
Triangles<T> grazing_triangles(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int digits = std::numeric_limits<T>::digits;
  Triangles<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Triangle<T> t{s.point(), s.point(), s.point()};
    const Vec3<T> p = inner_point(s, t), q = inner_point(s, t);
    const Vec3<T> normal = unit(perpendicular(difference(t.b, t.a), difference(t.c, t.a)));
    const Vec3<T> d = combination(unit(difference(p, q)), s.power(8 - digits, -5), normal, T(0), normal);
    mix.push_back({{combination(p, T(-2), d, T(0), d), d}, t});
  }
  return mix;
}

/// Aimed at triangles 2^10 ... 2^30 times as far as they are large (float: 2^18).
template <Real T>
Triangles<T> far_triangles(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int farthest = std::numeric_limits<T>::digits > 24 ? 30 : 18;
  Triangles<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const T size = s.power(-farthest, -10);
    const Vec3<T> e = s.point(), a = s.point();
    const Triangle<T> t{a, combination(a, size, s.point(), T(0), a), combination(a, size, s.point(), T(0), a)};
    mix.push_back({{e, difference(inner_point(s, t), e)}, t});
  }
  return mix;
}

/// Integers: every ray passes exactly through an edge or a corner.
template <Real T>
Triangles<T> boundary_triangles(std::size_t n, std::int64_t size, Source<T> s = Source<T>()) {
  Triangles<T> mix;
  while (mix.size() < n) {
    const Vec3<T> a = s.lattice_point(size), d = s.lattice_point(size), f = s.lattice_point(size / 16),
                  g = s.lattice_point(size / 16);
    const std::int64_t i = static_cast<std::int64_t>(s.below(17)), tau = static_cast<std::int64_t>(s.below(4)) + 1;
    const std::uint64_t edge = s.below(4);
    const Vec3<T> b = combination(a, T(16), f, T(0), g), c = combination(a, T(0), f, T(16), g);
    const T u = edge == 0 ? T(i) : edge == 1 ? T(0) : edge == 2 ? T(16 - i) : T(i < 8 ? 0 : 16);
    const T v = edge == 0 ? T(0) : edge == 1 ? T(i) : edge == 2 ? T(i) : T(0);
    const Vec3<T> p = combination(a, u, f, v, g);
    mix.push_back({{combination(p, -T(tau), d, T(0), d), d}, {a, b, c}});
  }
  return mix;
}

/// Half of them as above, half aimed at a rounded point of an edge: a hair beside it.
template <Real T>
Triangles<T> edge_triangles(std::size_t n, Source<T> s = Source<T>()) {
  Triangles<T> mix = boundary_triangles<T>(n / 2, std::numeric_limits<T>::digits > 24 ? 1 << 24 : 1 << 10, s);
  while (mix.size() < n) {
    const Triangle<T> t{s.point(), s.point(), s.point()};
    const Vec3<T> e = s.point(), p = combination(t.a, s.fraction(), difference(t.b, t.a), T(0), t.a);
    mix.push_back({{e, difference(p, e)}, t});
  }
  std::shuffle(mix.begin(), mix.end(), std::mt19937_64(default_seed));
  return mix;
}

/// Integers of [-2, 2]: edges, corners, coplanar rays, triangles without area.
template <Real T>
Triangles<T> lattice_triangles(std::size_t n, Source<T> s = Source<T>()) {
  Triangles<T> mix;
  while (mix.size() < n) {
    const Vec3<T> e = s.lattice_point(2), d = s.lattice_point(2), a = s.lattice_point(2), b = s.lattice_point(2),
                  c = s.lattice_point(2);
    if (d == Vec3<T>{}) continue;
    mix.push_back({{e, d}, {a, b, c}});
  }
  return mix;
}

}  // namespace graze::bench
