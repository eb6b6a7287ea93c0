// Rays and spheres that queries are timed on.
#pragma once

#include <algorithm>
#include <vector>

#include "bench/source.hpp"
#include "fuzz/case.hpp"

namespace graze::bench {

template <Real T>
using Spheres = std::vector<fuzz::RaySphere<T>>;

/// Centers, origins and directions uniform in the cube, radii uniform in [0, 1/2].
template <Real T>
Spheres<T> random_spheres(std::size_t n, Source<T> s = Source<T>()) {
  Spheres<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), c = s.point();
    mix.push_back({{e, d}, {c, s.fraction() / 2}});
  }
  return mix;
}

/// An eye before 64 x 64 balls, seen through pixels, each ray with the ball under its pixel: three of four are hit.
template <Real T>
Spheres<T> camera_spheres(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int cells = 64;
  const Vec3<T> eye{T(0.3), T(-0.4), T(3)};
  Spheres<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const int x = static_cast<int>(s.below(cells)), y = static_cast<int>(s.below(cells));
    const T px = (T(x) + s.fraction()) * 2 / cells - 1, py = (T(y) + s.fraction()) * 2 / cells - 1;
    const Vec3<T> center{(T(x) + T(0.5)) * 2 / cells - 1, (T(y) + T(0.5)) * 2 / cells - 1, T(0.05) * s.uniform()};
    mix.push_back({{eye, unit(difference(Vec3<T>{px, py, T(0)}, eye))}, {center, T(0.95) / cells}});
  }
  return mix;
}

/// Passing the limb at 2^-3 ... 2^-(digits - 3) of the radius, inside or outside.
template <Real T>
Spheres<T> grazing_spheres(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int digits = std::numeric_limits<T>::digits;
  Spheres<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), c = s.point();
    const Vec3<T> aside = unit(perpendicular(difference(c, e), s.point()));
    const T r = T(0.1) + s.fraction() / 4;
    // A ray from e at distance r from c, as far as rounding lets it.
    const Vec3<T> l = difference(c, e);
    const T l2 = l.x * l.x + l.y * l.y + l.z * l.z, away = std::sqrt(std::max(l2 - r * r, T(0)));
    const Vec3<T> limb = combination(c, -r * r / l2, l, r * away / std::sqrt(l2), aside);
    const T off = s.power(3 - digits, -3);
    mix.push_back({{e, difference(limb, e)}, {c, r * (s.coin() ? 1 + off : 1 - off)}});
  }
  return mix;
}

/// Aimed at spheres 2^10 ... 2^30 times as far as they are large (float: 2^18).
template <Real T>
Spheres<T> far_spheres(std::size_t n, Source<T> s = Source<T>()) {
  constexpr int farthest = std::numeric_limits<T>::digits > 24 ? 30 : 18;
  Spheres<T> mix;
  for (std::size_t i = 0; i < n; ++i) {
    const T size = s.power(-farthest, -10), r = size * (1 + s.fraction());
    const Vec3<T> e = s.point(), c = s.point();
    mix.push_back({{e, difference(combination(c, r * T(0.5), s.point(), T(0), c), e)}, {c, r}});
  }
  return mix;
}

/// Integer tangents from quaternions: the columns R1, R2, R3 of |q|^2 times a rotation are orthogonal and of length N = |q|^2;
/// d = R1, c = e + j R1 + beta R2, r = |beta| N.
template <Real T>
Spheres<T> tangent_spheres(std::size_t n, std::int64_t size, Source<T> s = Source<T>()) {
  Spheres<T> mix;
  while (mix.size() < n) {
    const T a = s.integer(size), b = s.integer(size), c = s.integer(size), d = s.integer(size);
    const T length = a * a + b * b + c * c + d * d;
    if (length == 0) continue;
    const Vec3<T> r1{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
    const Vec3<T> r2{2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)};
    const Vec3<T> e = s.lattice_point(1000);
    const T j = static_cast<T>(s.below(7)) - 1, beta = static_cast<T>(s.below(5)) - 2;
    mix.push_back({{e, r1}, {combination(e, j, r1, beta, r2), (beta < 0 ? -beta : beta) * length}});
  }
  return mix;
}

/// Half of them exact tangents, half with the origin on the sphere or a hair off it.
template <Real T>
Spheres<T> edge_spheres(std::size_t n, Source<T> s = Source<T>()) {
  Spheres<T> mix = tangent_spheres<T>(n / 2, std::numeric_limits<T>::digits > 24 ? 2048 : 8, s);
  while (mix.size() < n) {
    const Vec3<T> c = s.point(), d = s.point();
    const T r = T(0.1) + s.fraction();
    mix.push_back({{combination(c, r, unit(s.point()), T(0), c), d}, {c, r}});
  }
  std::shuffle(mix.begin(), mix.end(), std::mt19937_64(default_seed));
  return mix;
}

/// Integers of [-2, 2], radii of [0, 2]: tangents, origins on the sphere and at its center, points.
template <Real T>
Spheres<T> lattice_spheres(std::size_t n, Source<T> s = Source<T>()) {
  Spheres<T> mix;
  while (mix.size() < n) {
    const Vec3<T> e = s.lattice_point(2), d = s.lattice_point(2), c = s.lattice_point(2);
    if (d == Vec3<T>{}) continue;
    mix.push_back({{e, d}, {c, static_cast<T>(s.below(3))}});
  }
  return mix;
}

}  // namespace graze::bench
