// Implicit forms: f(p) = 0 on the surface, and the sign of f tells the sides apart.
// They fail alike: f is a sum of rounded products, so near the surface its sign is noise, a point on the surface seldom gives 0
// exactly, and a point off it may; large numbers give infinity or NaN, small ones 0.
// Source: Shirley, Marschner, "Fundamentals of Computer Graphics", chapter 2, implicit curves and surfaces.
#pragma once

#include "graze/textbook/vector.hpp"
#include "graze/types.hpp"

namespace graze::textbook {

/// f(x, y) = a x + b y + c. Its size is the distance times |(a, b)|, not the distance.
template <Real T>
[[nodiscard]] constexpr T f(const Vec2<T>& p, const Line<T>& line) noexcept {
  return line.a * p.x + line.b * p.y + line.c;
}

/// f(x, y, z) = a x + b y + c z + d.
template <Real T>
[[nodiscard]] constexpr T f(const Vec3<T>& p, const Plane<T>& plane) noexcept {
  return plane.a * p.x + plane.b * p.y + plane.c * p.z + plane.d;
}

/// f(p) = (p - center) . (p - center) - radius^2: negative inside. Near a large sphere two large squares cancel; the sign of
/// a negative radius is lost.
template <Real T>
[[nodiscard]] constexpr T f(const Vec3<T>& p, const Sphere<T>& sphere) noexcept {
  const Vec3<T> from_center = difference(p, sphere.center);
  return dot(from_center, from_center) - sphere.radius * sphere.radius;
}

}  // namespace graze::textbook
