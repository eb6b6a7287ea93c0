// The public arrays, or one ray or shape, as columns; and single lanes of them.
#pragma once

#include "batch/verdicts.hpp"
#include "graze/batch.hpp"
#include "graze/numeric/filter.hpp"

namespace graze::batch {

template <Real T>
[[nodiscard]] inline bool has_range(const Ray<T>& ray) noexcept {
  return !numeric::is_default_range(ray);
}
template <Real T>
[[nodiscard]] inline bool has_range(const RayArrays<T>& rays) noexcept {
  return rays.t_min != nullptr;
}

template <Real T>
[[nodiscard]] inline RayColumns<T> columns(const Ray<T>& ray) noexcept {
  const auto& [e, d, t_min, t_max] = ray;
  if (!has_range(ray)) return {{&e.x, &e.y, &e.z, &d.x, &d.y, &d.z, nullptr, nullptr}};
  return {{&e.x, &e.y, &e.z, &d.x, &d.y, &d.z, &t_min, &t_max}};
}
template <Real T>
[[nodiscard]] inline RayColumns<T> columns(const RayArrays<T>& rays) noexcept {
  const auto& [e, d, size, t_min, t_max] = rays;
  return {{e.x, e.y, e.z, d.x, d.y, d.z, t_min, t_max}};
}
template <Real T>
[[nodiscard]] inline TriangleColumns<T> columns(const Triangle<T>& t) noexcept {
  return {{&t.a.x, &t.a.y, &t.a.z, &t.b.x, &t.b.y, &t.b.z, &t.c.x, &t.c.y, &t.c.z}};
}
template <Real T>
[[nodiscard]] inline TriangleColumns<T> columns(const TriangleArrays<T>& t) noexcept {
  return {{t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}};
}
template <Real T>
[[nodiscard]] inline SphereColumns<T> columns(const Sphere<T>& s) noexcept {
  return {{&s.center.x, &s.center.y, &s.center.z, &s.radius}};
}
template <Real T>
[[nodiscard]] inline SphereColumns<T> columns(const SphereArrays<T>& s) noexcept {
  return {{s.center.x, s.center.y, s.center.z, s.radius}};
}

/// Lane i; one is every lane's.
template <Real T>
[[nodiscard]] inline const Ray<T>& lane(const Ray<T>& ray, std::size_t) noexcept {
  return ray;
}
template <Real T>
[[nodiscard]] inline const Triangle<T>& lane(const Triangle<T>& triangle, std::size_t) noexcept {
  return triangle;
}
template <Real T>
[[nodiscard]] inline const Sphere<T>& lane(const Sphere<T>& sphere, std::size_t) noexcept {
  return sphere;
}
template <Real T>
[[nodiscard]] inline Vec3<T> lane(const Vec3Arrays<T>& v, std::size_t i) noexcept {
  return {v.x[i], v.y[i], v.z[i]};
}
template <Real T>
[[nodiscard]] inline Ray<T> lane(const RayArrays<T>& rays, std::size_t i) noexcept {
  Ray<T> ray{lane(rays.origin, i), lane(rays.direction, i)};
  if (rays.t_min != nullptr) ray.t_min = rays.t_min[i];
  if (rays.t_max != nullptr) ray.t_max = rays.t_max[i];
  return ray;
}
template <Real T>
[[nodiscard]] inline Triangle<T> lane(const TriangleArrays<T>& t, std::size_t i) noexcept {
  return {lane(t.a, i), lane(t.b, i), lane(t.c, i)};
}
template <Real T>
[[nodiscard]] inline Sphere<T> lane(const SphereArrays<T>& s, std::size_t i) noexcept {
  return {lane(s.center, i), s.radius[i]};
}

template <class T>
inline constexpr bool is_array = requires(const T& t) {
  t.size;
};

/// How many lanes both sides have.
template <class Rays, class Shapes>
[[nodiscard]] inline std::size_t lanes(const Rays& rays, const Shapes& shapes) noexcept {
  if constexpr (is_array<Rays> && is_array<Shapes>) {
    return rays.size < shapes.size ? rays.size : shapes.size;
  } else if constexpr (is_array<Rays>) {
    return rays.size;
  } else {
    return shapes.size;
  }
}

}  // namespace graze::batch
