// The queries of the GMP oracle. Where `exact` is null, only the rounded answer is made.
#pragma once

#include "oracle/adapter.hpp"

namespace graze::oracle::gmp {

struct Queries {
  static constexpr std::string_view name = "gmp";

  template <Real T>
  [[nodiscard]] static SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere, ExactSphere* exact);
  template <Real T>
  [[nodiscard]] static TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle, ExactTriangle* exact);

  template <Real T>
  [[nodiscard]] static Side side(const Vec2<T>& point, const Line<T>& line);
  template <Real T>
  [[nodiscard]] static Side side(const Vec3<T>& point, const Plane<T>& plane);
  template <Real T>
  [[nodiscard]] static Side side(const Vec3<T>& point, const Sphere<T>& sphere);
};

}  // namespace graze::oracle::gmp
