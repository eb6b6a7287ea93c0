// A case: one query with its input, as the contract's case lines have it.
#pragma once

#include <variant>

#include "graze/answer.hpp"
#include "graze/types.hpp"

namespace graze::fuzz {

template <Real T>
struct RaySphere {
  Ray<T> ray;
  Sphere<T> sphere;
  bool operator==(const RaySphere&) const = default;
};
template <Real T>
struct RayTriangle {
  Ray<T> ray;
  Triangle<T> triangle;
  bool operator==(const RayTriangle&) const = default;
};
template <Real T>
struct PointLine {
  Vec2<T> point;
  Line<T> line;
  bool operator==(const PointLine&) const = default;
};
template <Real T>
struct PointPlane {
  Vec3<T> point;
  Plane<T> plane;
  bool operator==(const PointPlane&) const = default;
};
template <Real T>
struct PointSphere {
  Vec3<T> point;
  Sphere<T> sphere;
  bool operator==(const PointSphere&) const = default;
};

template <Real T>
using Case = std::variant<RaySphere<T>, RayTriangle<T>, PointLine<T>, PointPlane<T>, PointSphere<T>>;

/// The answer to a case, in the order of the alternatives of Case.
template <Real T>
using Answer = std::variant<SphereHit<T>, TriangleHit<T>, Side>;

/// Whether a point is common to ray and shape; false for points and invalid input.
template <Real T>
[[nodiscard]] constexpr bool is_hit(const SphereHit<T>& hit) {
  return hit.kind == SphereKind::tangent || hit.kind == SphereKind::secant;
}
template <Real T>
[[nodiscard]] constexpr bool is_hit(const TriangleHit<T>& hit) {
  return hit.kind != TriangleKind::miss && hit.kind != TriangleKind::invalid;
}
[[nodiscard]] constexpr bool is_hit(const Side&) {
  return false;
}
template <Real T>
[[nodiscard]] constexpr bool is_hit(const Answer<T>& answer) {
  return std::visit([](const auto& hit) { return is_hit(hit); }, answer);
}

}  // namespace graze::fuzz
