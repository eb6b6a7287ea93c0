// The numbers of a case by position, and its ray if it has one.
#pragma once

#include <array>
#include <cstddef>

#include "fuzz/case.hpp"

namespace graze::fuzz::construct {

/// Pointers to the numbers of a case, in the order of its case line; the ray's range is not among them.
template <Real T>
struct Coordinates {
  std::array<T*, 17> at{};
  std::size_t count = 0;
  std::size_t radius = 17;  ///< which one is a radius; 17 if none

  void add(T& number) { at[count++] = &number; }
  void add(Vec3<T>& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add_radius(T& number) {
    radius = count;
    add(number);
  }
};

template <Real T>
Coordinates<T> coordinates(Case<T>& input) {
  Coordinates<T> all;
  if (auto* sphere_case = std::get_if<RaySphere<T>>(&input)) {
    all.add(sphere_case->ray.origin);
    all.add(sphere_case->ray.direction);
    all.add(sphere_case->sphere.center);
    all.add_radius(sphere_case->sphere.radius);
  } else if (auto* triangle_case = std::get_if<RayTriangle<T>>(&input)) {
    all.add(triangle_case->ray.origin);
    all.add(triangle_case->ray.direction);
    all.add(triangle_case->triangle.a);
    all.add(triangle_case->triangle.b);
    all.add(triangle_case->triangle.c);
  } else if (auto* line_case = std::get_if<PointLine<T>>(&input)) {
    all.add(line_case->point.x);
    all.add(line_case->point.y);
    all.add(line_case->line.a);
    all.add(line_case->line.b);
    all.add(line_case->line.c);
  } else if (auto* plane_case = std::get_if<PointPlane<T>>(&input)) {
    all.add(plane_case->point);
    all.add(plane_case->plane.a);
    all.add(plane_case->plane.b);
    all.add(plane_case->plane.c);
    all.add(plane_case->plane.d);
  } else if (auto* point_case = std::get_if<PointSphere<T>>(&input)) {
    all.add(point_case->point);
    all.add(point_case->sphere.center);
    all.add_radius(point_case->sphere.radius);
  }
  return all;
}

template <Real T>
Ray<T>* ray_of(Case<T>& input) {
  if (auto* sphere_case = std::get_if<RaySphere<T>>(&input)) return &sphere_case->ray;
  if (auto* triangle_case = std::get_if<RayTriangle<T>>(&input)) return &triangle_case->ray;
  return nullptr;
}

}  // namespace graze::fuzz::construct
