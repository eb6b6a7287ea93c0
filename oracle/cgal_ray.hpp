// A ray with its range, and CGAL's own word on whether that part of the line meets a shape.
#pragma once

#include "oracle/cgal_values.hpp"

namespace graze::oracle::cgal {

struct BoundedRay {
  Point origin;
  Vector direction;
  Number t_min, t_max;
  bool bounded = false;  ///< whether t_max counts

  [[nodiscard]] Point at(const Number& t) const { return origin + direction * t; }
  [[nodiscard]] Point second_point() const { return origin + direction; }
  [[nodiscard]] Line line() const { return Line(origin, direction); }

  template <class Value>
  [[nodiscard]] bool contains(const Value& t) const {
    return compare(t, t_min) != CGAL::SMALLER && (!bounded || compare(t, t_max) != CGAL::LARGER);
  }
};

template <Real T>
[[nodiscard]] BoundedRay bounded_ray(const Ray<T>& ray) {
  const bool bounded = std::isfinite(ray.t_max);
  return {point(ray.origin), vector(ray.direction), Number(ray.t_min), bounded ? Number(ray.t_max) : Number(0), bounded};
}

/// Whether CGAL::do_intersect finds a common point. A range of one point is no segment to CGAL: `has_point` answers then.
template <class Shape, class HasPoint>
[[nodiscard]] bool cgal_meets(const BoundedRay& ray, const Shape& shape, HasPoint has_point) {
  const Point start = ray.at(ray.t_min);
  if (!ray.bounded) return CGAL::do_intersect(Kernel::Ray_3(start, ray.direction), shape);
  if (ray.t_min == ray.t_max) return has_point(start);
  return CGAL::do_intersect(Kernel::Segment_3(start, ray.at(ray.t_max)), shape);
}

}  // namespace graze::oracle::cgal
