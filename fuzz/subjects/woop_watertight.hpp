// Ray and triangle by Woop, Benthin and Wald, "Watertight ray/triangle intersection", Journal of Computer Graphics Techniques
// 2(1), 2013. The triangle is sheared into a space where the ray is the z axis; three 2-d edge functions decide. Each is a
// difference of two products that reads the same for both triangles of an edge, so rays do not slip between them. For float, an
// edge function that is 0 is computed again in double.
// Fails all the same: the shear is rounded, so corners move and a ray aimed at an edge may hit beside it, lose a triangle's rim
// to its neighbour, or call a face hit an edge; t and u, v have no right digit for slivers; products under- and overflow; rays
// with two vanishing shears and large offsets cancel. A determinant of 0 is a miss: coplanar rays, degenerate triangles.
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook/vector.hpp"

namespace graze::fuzz::woop_watertight {

template <Real T>
std::array<T, 3> coordinates(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// The ray's part: the axes in the order in which the direction's largest comes last, and the shear.
template <Real T>
struct Shear {
  std::size_t x, y, z;
  T sx, sy, sz;

  explicit Shear(const Vec3<T>& direction) {
    const std::array<T, 3> d = coordinates(direction);
    z = 0;
    if (std::abs(d[1]) > std::abs(d[z])) z = 1;
    if (std::abs(d[2]) > std::abs(d[z])) z = 2;
    x = (z + 1) % 3;
    y = (x + 1) % 3;
    if (d[z] < 0) std::swap(x, y);  // keeps the winding
    sx = d[x] / d[z];
    sy = d[y] / d[z];
    sz = 1 / d[z];
  }
};

/// A corner relative to the origin, sheared: x and y in the plane across the ray, z along it, not yet scaled.
template <Real T>
Vec3<T> sheared(const Vec3<T>& corner, const Vec3<T>& origin, const Shear<T>& shear) {
  const std::array<T, 3> p = coordinates(textbook::difference(corner, origin));
  return {p[shear.x] - shear.sx * p[shear.z], p[shear.y] - shear.sy * p[shear.z], p[shear.z]};
}

template <Real T>
T edge_function(const Vec3<T>& p, const Vec3<T>& q) {
  return q.x * p.y - q.y * p.x;
}

template <Real T>
TriangleKind feature(T a, T b, T c) {
  if (a == 0) return b == 0 ? TriangleKind::vertex_c : c == 0 ? TriangleKind::vertex_b : TriangleKind::edge_bc;
  if (b == 0) return c == 0 ? TriangleKind::vertex_a : TriangleKind::edge_ca;
  return c == 0 ? TriangleKind::edge_ab : TriangleKind::face;
}

struct Formula {
  static constexpr std::string_view name = "woop-watertight";
  static constexpr std::string_view about =
      "sheared edge functions, in double where one is 0 in float; Woop, Benthin, Wald, Watertight ray/triangle intersection, "
      "JCGT "
      "2(1) 2013";
  static constexpr Deviations deviations{
      {Deviation::coplanar_is_miss, Deviation::degenerate_is_miss, Deviation::invalid_unhandled}};

  template <Real T>
  static TriangleHit<T> answer(const RayTriangle<T>& query) {
    TriangleHit<T> hit;
    const Shear<T> shear(query.ray.direction);
    const Vec3<T> a = sheared(query.triangle.a, query.ray.origin, shear);
    const Vec3<T> b = sheared(query.triangle.b, query.ray.origin, shear);
    const Vec3<T> c = sheared(query.triangle.c, query.ray.origin, shear);
    // The weights of the corners, times the determinant.
    T wa = edge_function(b, c), wb = edge_function(c, a), wc = edge_function(a, b);
    if constexpr (std::same_as<T, float>) {
      if (wa == 0 || wb == 0 || wc == 0) {
        const auto wide = [](const Vec3<float>& v) { return Vec3<double>{v.x, v.y, v.z}; };
        wa = static_cast<float>(edge_function(wide(b), wide(c)));
        wb = static_cast<float>(edge_function(wide(c), wide(a)));
        wc = static_cast<float>(edge_function(wide(a), wide(b)));
      }
    }
    const T determinant = wa + wb + wc;
    hit.facing = determinant > 0 ? Facing::front : determinant < 0 ? Facing::back : Facing::none;
    if ((wa < 0 || wb < 0 || wc < 0) && (wa > 0 || wb > 0 || wc > 0)) return hit;
    if (!(determinant != 0)) return hit;
    const T inverse = 1 / determinant;
    const T t = (wa * (shear.sz * a.z) + wb * (shear.sz * b.z) + wc * (shear.sz * c.z)) * inverse;
    if (!(query.ray.t_min <= t && t <= query.ray.t_max)) return hit;
    hit.kind = feature(wa, wb, wc);
    hit.t = hit.t_end = t;
    hit.u = wb * inverse;
    hit.v = wc * inverse;
    return hit;
  }
};

}  // namespace graze::fuzz::woop_watertight
