// The inputs that queries are timed on: pairs of a ray and a shape, made from a fixed seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "graze/types.hpp"

namespace graze::bench {

template <Real T>
struct TriangleMix {
  std::string_view name;
  std::vector<Ray<T>> rays;
  std::vector<Triangle<T>> shapes;
};

template <Real T>
struct SphereMix {
  std::string_view name;
  std::vector<Ray<T>> rays;
  std::vector<Sphere<T>> shapes;
};

template <Real T>
class Source {
 public:
  /// In [-1, 1].
  T uniform() { return static_cast<T>(static_cast<double>(bits_()) * 0x1p-63 - 1); }
  /// In [0, 1].
  T fraction() { return static_cast<T>(static_cast<double>(bits_()) * 0x1p-64); }
  /// An integer in [-n, n].
  T integer(std::int64_t n) {
    return static_cast<T>(static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(2 * n + 1)) - n);
  }
  bool coin() { return (bits_() & 1) != 0; }
  std::uint64_t below(std::uint64_t n) { return bits_() % n; }
  Vec3<T> point() {
    const T x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }
  Vec3<T> lattice_point(std::int64_t n) {
    const T x = integer(n), y = integer(n), z = integer(n);
    return {x, y, z};
  }

 private:
  std::mt19937_64 bits_{20260101};
};

template <Real T>
Vec3<T> combination(const Vec3<T>& p, T s, const Vec3<T>& q, T r, const Vec3<T>& v) {
  return {p.x + s * q.x + r * v.x, p.y + s * q.y + r * v.y, p.z + s * q.z + r * v.z};
}

template <Real T>
Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Everything uniform in the cube [-1, 1]^3: few hits.
template <Real T>
TriangleMix<T> random_triangles(std::size_t n) {
  Source<T> s;
  TriangleMix<T> mix{"random (few hits)", {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), a = s.point(), b = s.point(), c = s.point();
    mix.rays.push_back({e, d});
    mix.shapes.push_back({a, b, c});
  }
  return mix;
}

/// As random, but every other ray is aimed at a point of the face.
template <Real T>
TriangleMix<T> half_hit_triangles(std::size_t n) {
  Source<T> s;
  TriangleMix<T> mix{"half of them hit", {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), a = s.point(), b = s.point(), c = s.point();
    T u = s.fraction(), v = s.fraction();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3<T> p = combination(a, u, difference(b, a), v, difference(c, a));
    const bool aimed = s.coin();
    mix.rays.push_back({e, aimed ? difference(p, e) : d});
    mix.shapes.push_back({a, b, c});
  }
  return mix;
}

/// Integers: every ray passes exactly through an edge or a corner.
template <Real T>
TriangleMix<T> boundary_triangles(std::size_t n, std::int64_t size) {
  Source<T> s;
  TriangleMix<T> mix{size > 1 << 16 ? "edges and corners, 24-bit lattice" : "edges and corners, 10-bit lattice", {}, {}};
  while (mix.rays.size() < n) {
    const Vec3<T> a = s.lattice_point(size), d = s.lattice_point(size), f = s.lattice_point(size / 16),
                  g = s.lattice_point(size / 16);
    const std::int64_t i = static_cast<std::int64_t>(s.below(17)), tau = static_cast<std::int64_t>(s.below(4)) + 1;
    const std::uint64_t edge = s.below(4);
    const Vec3<T> b = combination(a, T(16), f, T(0), g), c = combination(a, T(0), f, T(16), g);
    const T u = edge == 0 ? T(i) : edge == 1 ? T(0) : edge == 2 ? T(16 - i) : T(i < 8 ? 0 : 16);
    const T v = edge == 0 ? T(0) : edge == 1 ? T(i) : edge == 2 ? T(i) : T(0);
    const Vec3<T> p = combination(a, u, f, v, g);
    mix.rays.push_back({combination(p, -T(tau), d, T(0), d), d});
    mix.shapes.push_back({a, b, c});
  }
  return mix;
}

/// Centers, origins and directions uniform in the cube, radii uniform in [0, 1/2].
template <Real T>
SphereMix<T> random_spheres(std::size_t n) {
  Source<T> s;
  SphereMix<T> mix{"random", {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), c = s.point();
    const T r = s.fraction() / 2;
    mix.rays.push_back({e, d});
    mix.shapes.push_back({c, r});
  }
  return mix;
}

/// As random, but every other ray is aimed into the sphere.
template <Real T>
SphereMix<T> half_hit_spheres(std::size_t n) {
  Source<T> s;
  SphereMix<T> mix{"half of them aimed", {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3<T> e = s.point(), d = s.point(), c = s.point(), p = s.point();
    const T r = s.fraction() / 2;
    const bool aimed = s.coin();
    mix.rays.push_back({e, aimed ? difference(combination(c, r / 2, p, T(0), p), e) : d});
    mix.shapes.push_back({c, r});
  }
  return mix;
}

/// Integer tangents from quaternions: the columns R1, R2, R3 of |q|^2 times a rotation are orthogonal and of length N = |q|^2;
/// d = R1, c = e + j R1 + beta R2, r = |beta| N.
template <Real T>
SphereMix<T> tangent_spheres(std::size_t n, std::int64_t size) {
  Source<T> s;
  SphereMix<T> mix{size > 100 ? "tangents, quaternions to 2048" : "tangents, quaternions to 8", {}, {}};
  while (mix.rays.size() < n) {
    const T a = s.integer(size), b = s.integer(size), c = s.integer(size), d = s.integer(size);
    const T length = a * a + b * b + c * c + d * d;
    if (length == 0) continue;
    const Vec3<T> r1{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
    const Vec3<T> r2{2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)};
    const Vec3<T> e = s.lattice_point(1000);
    const T j = static_cast<T>(s.below(7)) - 1, beta = static_cast<T>(s.below(5)) - 2;
    mix.rays.push_back({e, r1});
    mix.shapes.push_back({combination(e, j, r1, beta, r2), (beta < 0 ? -beta : beta) * length});
  }
  return mix;
}

}  // namespace graze::bench
