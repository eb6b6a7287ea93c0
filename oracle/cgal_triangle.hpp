// Ray and triangle: decided by orientations of points, answered by quotients of determinants.
#pragma once

#include "graze/answer.hpp"
#include "oracle/adapter.hpp"
#include "oracle/cgal_planar.hpp"
#include "oracle/cgal_rounding.hpp"
#include "oracle/cgal_status.hpp"

namespace graze::oracle::cgal {

template <Real T>
void set_interval(TriangleHit<T>& hit, TriangleKind kind, const std::optional<Interval>& part, ExactTriangle* exact) {
  if (!part) return;
  hit.kind = kind;
  hit.t = nearest<T>(part->lower);
  hit.t_end = nearest<T>(part->upper);
  if (exact == nullptr) return;
  exact->t = to_exact(part->lower);
  exact->t_end = to_exact(part->upper);
}

/// On which side of each edge the ray's line passes, as multiples of the facing: 0 on the edge's line, 1 inside, -1 outside.
struct EdgeSides {
  int ab, bc, ca;
  [[nodiscard]] bool outside() const { return ab < 0 || bc < 0 || ca < 0; }

  [[nodiscard]] TriangleKind feature() const {
    if (ab == 0) return ca == 0 ? TriangleKind::vertex_a : (bc == 0 ? TriangleKind::vertex_b : TriangleKind::edge_ab);
    if (bc == 0) return ca == 0 ? TriangleKind::vertex_c : TriangleKind::edge_bc;
    return ca == 0 ? TriangleKind::edge_ca : TriangleKind::face;
  }
};

[[nodiscard]] inline EdgeSides edge_sides(const BoundedRay& ray, const Corners& corners, CGAL::Orientation facing) {
  const auto& [a, b, c] = corners;
  const Point second = ray.second_point();
  const auto side = [&](const Point& p, const Point& q) {
    return static_cast<int>(CGAL::orientation(ray.origin, second, p, q)) * static_cast<int>(facing);
  };
  return {side(a, b), side(b, c), side(c, a)};
}

/// The ray's line crosses the plane in one point.
template <Real T>
void meet_crossing(TriangleHit<T>& hit, const BoundedRay& ray, const Corners& corners, CGAL::Orientation facing,
                   ExactTriangle* exact) {
  const EdgeSides sides = edge_sides(ray, corners, facing);
  if (sides.outside()) return;
  const Vector to_a = corners[0] - ray.origin;
  const Vector to_b = corners[1] - ray.origin;
  const Vector to_c = corners[2] - ray.origin;
  const Number whole = CGAL::determinant(corners[1] - corners[0], corners[2] - corners[0], ray.direction);
  const Field t(CGAL::determinant(to_a, to_b, to_c), whole);
  if (!ray.contains(t)) return;
  const Field u(CGAL::determinant(ray.direction, to_c, to_a), whole);
  const Field v(CGAL::determinant(ray.direction, to_a, to_b), whole);
  hit.kind = sides.feature();
  hit.t = nearest<T>(t);
  hit.t_end = hit.t;
  hit.u = nearest<T>(u);
  hit.v = nearest<T>(v);
  if (exact != nullptr) *exact = {to_exact(t), to_exact(t), to_exact(u), to_exact(v)};
}

template <Real T>
[[nodiscard]] TriangleHit<T> intersect_triangle(const Ray<T>& input, const Triangle<T>& triangle, ExactTriangle* exact) {
  TriangleHit<T> hit;
  hit.status = status_of(input, triangle);
  if (hit.status != Status::ok) {
    hit.kind = TriangleKind::invalid;
    return hit;
  }
  const BoundedRay ray = bounded_ray(input);
  const Corners corners{point(triangle.a), point(triangle.b), point(triangle.c)};
  const auto& [a, b, c] = corners;

  if (CGAL::collinear(a, b, c)) {
    if (coplanar_with_degenerate(ray, corners)) set_interval(hit, TriangleKind::degenerate, common_part(ray, corners), exact);
    confirm(cgal_meets_degenerate(ray, corners) == (hit.kind != TriangleKind::miss), "ray and degenerate triangle");
    return hit;
  }
  const CGAL::Orientation facing = CGAL::orientation(a, b, c, a + ray.direction);
  if (facing != CGAL::COPLANAR) {
    hit.facing = facing == CGAL::NEGATIVE ? Facing::front : Facing::back;
    meet_crossing(hit, ray, corners, facing, exact);
  } else if (CGAL::coplanar(a, b, c, ray.origin)) {
    set_interval(hit, TriangleKind::coplanar, common_part(ray, corners), exact);
  }
  const Kernel::Triangle_3 whole(a, b, c);
  const bool meets = cgal_meets(ray, whole, [&whole](const Point& p) { return whole.has_on(p); });
  confirm(meets == (hit.kind != TriangleKind::miss), "ray and triangle");
  return hit;
}

}  // namespace graze::oracle::cgal
