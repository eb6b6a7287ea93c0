// What is asked about: rays, spheres, triangles, lines, planes. Plain data, no invariants: an invalid value is answered, never
// refused.
#pragma once

#include <concepts>
#include <limits>

namespace graze {

/// The two input formats: IEEE-754 binary32 and binary64. Each value stands for exactly the rational number that it is.
template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double>;

template <Real T>
struct Vec2 {
  T x{}, y{};
  bool operator==(const Vec2&) const = default;
};

template <Real T>
struct Vec3 {
  T x{}, y{}, z{};
  bool operator==(const Vec3&) const = default;
};

/// The points origin + t * direction with t_min <= t <= t_max, both ends included.
/// `direction` has any length but zero. `t_min` is finite; `t_max` is finite or +infinity.
template <Real T>
struct Ray {
  Vec3<T> origin, direction;
  T t_min = T(0);
  T t_max = std::numeric_limits<T>::infinity();
  bool operator==(const Ray&) const = default;
};

/// The surface |p - center| = radius, not the ball. radius >= 0; a sphere of radius 0 is its center.
template <Real T>
struct Sphere {
  Vec3<T> center;
  T radius{};
  bool operator==(const Sphere&) const = default;
};

/// The points a + u (b - a) + v (c - a) with u >= 0, v >= 0, u + v <= 1. It may be degenerate: a segment or a point.
template <Real T>
struct Triangle {
  Vec3<T> a, b, c;
  bool operator==(const Triangle&) const = default;
};

/// The zero set of f(x, y) = a x + b y + c. With a = b = 0, f is a constant, which is valid.
template <Real T>
struct Line {
  T a{}, b{}, c{};
  bool operator==(const Line&) const = default;
};

/// The zero set of f(x, y, z) = a x + b y + c z + d. With a = b = c = 0, f is a constant, which is valid.
template <Real T>
struct Plane {
  T a{}, b{}, c{}, d{};
  bool operator==(const Plane&) const = default;
};

}  // namespace graze
