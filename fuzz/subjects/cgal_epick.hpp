// Ray and triangle by CGAL's Exact_predicates_inexact_constructions_kernel: whether they meet is decided exactly, where is
// computed in double. A point is told as a face hit, a segment as coplanar. Fails because EPICK keeps a ray as two points, and
// the second one, e + d, is rounded: what is decided exactly is another ray's answer. Where e + d overflows, or is e again,
// there is no ray, and the answer is a miss. The point is rounded, so t, u and v, read off its coordinates, are off, without
// bound for slivers. A range other than the default is tested on the computed t of the line. What CGAL refuses (degenerate
// triangles, zero directions, numbers that are not finite) never reaches it and is a miss.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Ray_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>

#include <cmath>
#include <string_view>

#include "fuzz/subject.hpp"
#include "graze/textbook/vector.hpp"

namespace graze::fuzz::cgal_epick {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point point(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}

Vec3<double> coordinates(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

bool is_finite(const Vec3<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <Real T>
Vec3<double> wide(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// The parameter of a point of the ray, by the largest component of its direction.
double parameter(const Vec3<double>& p, const Ray<double>& ray) {
  const Vec3<double> along = textbook::difference(p, ray.origin), &d = ray.direction;
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  return x >= y && x >= z ? along.x / d.x : y >= z ? along.y / d.y : along.z / d.z;
}

/// The coordinates of a point of the triangle's plane, by the largest component of the normal.
void set_coordinates(const Vec3<double>& p, const Triangle<double>& triangle, TriangleHit<double>& hit) {
  const Vec3<double> ab = textbook::difference(triangle.b, triangle.a), ac = textbook::difference(triangle.c, triangle.a);
  const Vec3<double> ap = textbook::difference(p, triangle.a), n = textbook::cross(ab, ac);
  const Vec3<double> un = textbook::cross(ap, ac), vn = textbook::cross(ab, ap);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const auto ratio = [&](const Vec3<double>& m) { return x >= y && x >= z ? m.x / n.x : y >= z ? m.y / n.y : m.z / n.z; };
  hit.u = ratio(un);
  hit.v = ratio(vn);
}

/// The hit from what CGAL constructed: an optional variant of point and segment.
template <class Intersection>
TriangleHit<double> hit_of(const Intersection& common, const Ray<double>& ray, const Triangle<double>& triangle) {
  TriangleHit<double> hit;
  if (!common) return hit;
  if (const Point* p = boost::get<Point>(&*common)) {
    hit.t = hit.t_end = parameter(coordinates(*p), ray);
    if (!(ray.t_min <= hit.t && hit.t <= ray.t_max)) return {};
    set_coordinates(coordinates(*p), triangle, hit);
    hit.kind = TriangleKind::face;
    return hit;
  }
  const auto& segment = boost::get<Kernel::Segment_3>(*common);
  const double s = parameter(coordinates(segment.source()), ray), t = parameter(coordinates(segment.target()), ray);
  hit.t = std::max(std::min(s, t), ray.t_min);
  hit.t_end = std::min(std::max(s, t), ray.t_max);
  if (!(hit.t <= hit.t_end)) return {};
  hit.kind = TriangleKind::coplanar;
  return hit;
}

TriangleHit<double> intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
  const Vec3<double> second{ray.origin.x + ray.direction.x, ray.origin.y + ray.direction.y, ray.origin.z + ray.direction.z};
  for (const Vec3<double>& v : {ray.origin, ray.direction, second, triangle.a, triangle.b, triangle.c}) {
    if (!is_finite(v)) return {};
  }
  const Point e = point(ray.origin), f = point(second);
  const Kernel::Triangle_3 shape(point(triangle.a), point(triangle.b), point(triangle.c));
  if (e == f || shape.is_degenerate()) return {};
  const bool is_default = ray.t_min == 0 && ray.t_max == std::numeric_limits<double>::infinity();
  if (is_default) return hit_of(CGAL::intersection(Kernel::Ray_3(e, f), shape), ray, triangle);
  return hit_of(CGAL::intersection(Kernel::Line_3(e, f), shape), ray, triangle);
}

struct Formula {
  static constexpr std::string_view name = "cgal-epick";
  static constexpr std::string_view about =
      "CGAL's intersection(Ray_3, Triangle_3) with exact predicates and inexact constructions (EPICK)";
  static constexpr Deviations deviations{
      {Deviation::degenerate_is_miss, Deviation::edges_are_faces, Deviation::no_facing, Deviation::invalid_unhandled}};

  template <Real T>
  static Reply<T> answer(const RayTriangle<T>& query) {
    const Ray<double> ray{wide(query.ray.origin), wide(query.ray.direction), query.ray.t_min, query.ray.t_max};
    const Triangle<double> triangle{wide(query.triangle.a), wide(query.triangle.b), wide(query.triangle.c)};
    try {
      const TriangleHit<double> hit = intersect(ray, triangle);
      TriangleHit<T> narrow;
      narrow.kind = hit.kind;
      narrow.t = static_cast<T>(hit.t);
      narrow.t_end = static_cast<T>(hit.t_end);
      narrow.u = static_cast<T>(hit.u);
      narrow.v = static_cast<T>(hit.v);
      return Answer<T>(narrow);
    } catch (const CGAL::Failure_exception& failure) {
      return Reply<T>::failed("CGAL's own check failed: " + failure.expression());
    }
  }
};

}  // namespace graze::fuzz::cgal_epick
