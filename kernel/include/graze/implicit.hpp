// Implicit surfaces f(p) = 0: on which side a point lies, exactly. The same bits everywhere, as for graze/triangle.hpp.
#pragma once

#include "graze/answer.hpp"
#include "graze/predicates/implicit_filter.hpp"

namespace graze {

namespace exact {
template <Real T>
[[nodiscard]] Side side(const Vec2<T>& point, const Line<T>& line) noexcept;
template <Real T>
[[nodiscard]] Side side(const Vec3<T>& point, const Plane<T>& plane) noexcept;
template <Real T>
[[nodiscard]] Side side(const Vec3<T>& point, const Sphere<T>& sphere) noexcept;
}  // namespace exact

/// The sign of f(x, y) = a x + b y + c, zero exactly on the line; non_finite where a number is not finite.
template <Real T>
[[nodiscard]] inline Side side(const Vec2<T>& point, const Line<T>& line) noexcept {
  const predicates::BoundedValue f = predicates::value(point, line);
  return f.is_certain() ? Side{Status::ok, f.sign()} : exact::side(point, line);
}

/// The sign of f(x, y, z) = a x + b y + c z + d, zero exactly on the plane; non_finite where a number is not finite.
template <Real T>
[[nodiscard]] inline Side side(const Vec3<T>& point, const Plane<T>& plane) noexcept {
  const predicates::BoundedValue f = predicates::value(point, plane);
  return f.is_certain() ? Side{Status::ok, f.sign()} : exact::side(point, plane);
}

/// The sign of f(p) = |p - center|^2 - radius^2: negative inside, zero exactly on the surface, positive outside; non_finite
/// where a number is not finite, negative_radius where radius < 0.
template <Real T>
[[nodiscard]] inline Side side(const Vec3<T>& point, const Sphere<T>& sphere) noexcept {
  const predicates::BoundedValue f = predicates::value(point, sphere);
  return f.is_certain() ? Side{Status::ok, f.sign()} : exact::side(point, sphere);
}

}  // namespace graze
