// Ray and sphere: decided by CGAL's Sphere_3 and the discriminant A r^2 - |d x L|^2, answered by roots of a quadratic.
#pragma once

#include "graze/answer.hpp"
#include "oracle/adapter.hpp"
#include "oracle/cgal_ray.hpp"
#include "oracle/cgal_rounding.hpp"
#include "oracle/cgal_status.hpp"

namespace graze::oracle::cgal {

using CgalSphere = Kernel::Sphere_3;

template <Real T>
[[nodiscard]] CgalSphere cgal_sphere(const Sphere<T>& sphere) {
  const Number radius(sphere.radius);
  return CgalSphere(point(sphere.center), radius * radius);
}

[[nodiscard]] inline OriginSide origin_side(const CgalSphere& sphere, const Point& origin) {
  switch (sphere.bounded_side(origin)) {
    case CGAL::ON_BOUNDED_SIDE:
      return OriginSide::inside;
    case CGAL::ON_BOUNDARY:
      return OriginSide::on;
    default:
      return OriginSide::outside;
  }
}

/// Writes a hit's next value.
template <Real T, class Value>
void append(SphereHit<T>& hit, int index, const Value& value, ExactSphere* exact) {
  hit.t[index] = nearest<T>(value);
  if (exact != nullptr) exact->t[index] = to_exact(value);
}

/// The part of an answer that needs the line to touch or to cross the sphere.
template <Real T>
void meet_sphere(SphereHit<T>& hit, const BoundedRay& ray, const Number& a, const Number& b, const Number& discriminant,
                 ExactSphere* exact) {
  if (CGAL::is_zero(discriminant)) {
    const Field t(b, a);
    if (!ray.contains(t)) return;
    hit.kind = SphereKind::tangent;
    hit.root = Root::both;
    append(hit, 0, t, exact);
    return;
  }
  const QuadraticRoot first{QuadraticRoot::Numerator(b, Number(-1), discriminant), a};
  const QuadraticRoot second{QuadraticRoot::Numerator(b, Number(1), discriminant), a};
  const bool has_first = ray.contains(first);
  const bool has_second = ray.contains(second);
  if (!has_first && !has_second) return;
  hit.kind = SphereKind::secant;
  hit.root = has_first ? (has_second ? Root::both : Root::first) : Root::second;
  int count = 0;
  if (has_first) append(hit, count++, first, exact);
  if (has_second) append(hit, count++, second, exact);
}

template <Real T>
[[nodiscard]] SphereHit<T> intersect_sphere(const Ray<T>& input, const Sphere<T>& surface, ExactSphere* exact) {
  SphereHit<T> hit;
  hit.status = status_of(input, surface);
  if (hit.status != Status::ok) {
    hit.kind = SphereKind::invalid;
    return hit;
  }
  const BoundedRay ray = bounded_ray(input);
  const CgalSphere sphere = cgal_sphere(surface);
  const Vector to_center = sphere.center() - ray.origin;
  const Number a = ray.direction.squared_length();
  const Number b = ray.direction * to_center;
  const Number discriminant = a * sphere.squared_radius() - CGAL::cross_product(ray.direction, to_center).squared_length();
  hit.origin = origin_side(sphere, ray.origin);
  confirm(CGAL::do_intersect(ray.line(), sphere) == (CGAL::sign(discriminant) != CGAL::NEGATIVE), "line and sphere");
  if (CGAL::sign(discriminant) != CGAL::NEGATIVE) meet_sphere(hit, ray, a, b, discriminant, exact);
  const bool meets = cgal_meets(ray, sphere, [&sphere](const Point& p) { return sphere.has_on_boundary(p); });
  confirm(meets == (hit.kind != SphereKind::miss), "ray and sphere");
  return hit;
}

}  // namespace graze::oracle::cgal
