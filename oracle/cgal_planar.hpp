// The common part of a line and a triangle in one plane, the triangle perhaps without area: from the corners that lie on the
// line and the edges whose ends lie on different sides of it.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "oracle/cgal_ray.hpp"

namespace graze::oracle::cgal {

using Corners = std::array<Point, 3>;

struct Interval {
  Field lower, upper;
};

/// The t of a point on the line.
[[nodiscard]] inline Field parameter_of(const BoundedRay& ray, const Point& p) {
  return Field((p - ray.origin) * ray.direction, ray.direction.squared_length());
}

/// The t at which the line crosses an edge that is not parallel to it.
[[nodiscard]] inline Field crossing_parameter(const BoundedRay& ray, const Point& p, const Point& q) {
  const Vector normal = CGAL::cross_product(ray.direction, q - p);
  return Field(CGAL::cross_product(p - ray.origin, q - p) * normal, normal.squared_length());
}

/// All t at which the line is in the triangle's hull; ray and corners lie in one plane.
[[nodiscard]] inline std::optional<Interval> common_part_of_line(const BoundedRay& ray, const Corners& corners) {
  std::optional<Interval> part;
  const auto include = [&part](const Field& t) {
    if (!part) part = {t, t};
    part->lower = (CGAL::min)(part->lower, t);
    part->upper = (CGAL::max)(part->upper, t);
  };
  const auto side = [&ray](const Point& p) { return CGAL::coplanar_orientation(ray.origin, ray.second_point(), p); };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& p = corners[i];
    const Point& q = corners[(i + 1) % 3];
    if (side(p) == CGAL::COLLINEAR) {
      include(parameter_of(ray, p));
    } else if (side(q) == -side(p)) {
      include(crossing_parameter(ray, p, q));
    }
  }
  return part;
}

/// The part within the ray's range.
[[nodiscard]] inline std::optional<Interval> common_part(const BoundedRay& ray, const Corners& corners) {
  std::optional<Interval> part = common_part_of_line(ray, corners);
  if (!part) return {};
  part->lower = (CGAL::max)(part->lower, Field(ray.t_min));
  if (ray.bounded) part->upper = (CGAL::min)(part->upper, Field(ray.t_max));
  if (CGAL::compare(part->lower, part->upper) == CGAL::LARGER) return {};
  return part;
}

/// Whether line and triangle without area lie in one plane.
[[nodiscard]] inline bool coplanar_with_degenerate(const BoundedRay& ray, const Corners& corners) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!CGAL::coplanar(ray.origin, ray.second_point(), corners[i], corners[(i + 1) % 3])) return false;
  }
  return true;
}

/// CGAL's own word on a triangle without area: one of its edges meets the ray, or the point that it is does.
[[nodiscard]] inline bool cgal_meets_degenerate(const BoundedRay& ray, const Corners& corners) {
  bool is_point = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& p = corners[i];
    const Point& q = corners[(i + 1) % 3];
    if (p == q) continue;
    is_point = false;
    const Kernel::Segment_3 edge(p, q);
    if (cgal_meets(ray, edge, [&edge](const Point& at) { return edge.has_on(at); })) return true;
  }
  if (!is_point) return false;
  const Point start = ray.at(ray.t_min);
  if (!ray.bounded) return Kernel::Ray_3(start, ray.direction).has_on(corners[0]);
  if (ray.t_min == ray.t_max) return start == corners[0];
  return Kernel::Segment_3(start, ray.at(ray.t_max)).has_on(corners[0]);
}

}  // namespace graze::oracle::cgal
