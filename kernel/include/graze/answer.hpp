// What is answered: kinds, features, statuses and numbers. Kinds are exact; every number is correctly rounded
// (nearest, ties to even, subnormal results and overflow to infinity included), and zero is always +0.
#pragma once

#include <cstdint>

#include "graze/types.hpp"

namespace graze {

/// Why an input has no answer. Tested in this order; the first that holds is told.
enum class Status : std::uint8_t {
  ok,
  non_finite,       ///< a NaN, or an infinity other than t_max = +infinity
  zero_direction,   ///< the ray's direction is the zero vector
  negative_radius,  ///< radius < 0
  empty_range,      ///< t_min > t_max
};

/// The sign of a real number. Never "uncertain": that is a value of its own inside the kernel.
enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

/// `side(point, surface)`: the sign of f(point), zero exactly when the point lies on the surface.
/// For a sphere f(p) = |p - center|^2 - radius^2: negative is inside.
struct Side {
  Status status = Status::ok;
  Sign sign = Sign::zero;  ///< meaningless unless status is ok
  bool operator==(const Side&) const = default;
};

enum class SphereKind : std::uint8_t {
  invalid,  ///< see `status`; nothing else in the answer has a meaning
  miss,     ///< no point of the ray on the sphere
  tangent,  ///< the line touches the sphere, at t[0], within the ray's range
  secant,   ///< the line crosses the sphere twice; one or both crossings lie within the range
};

/// Which crossings of a line and a sphere lie in the ray's range. A tangent's double root is both.
enum class Root : std::uint8_t { none, first, second, both };

/// Where the ray's origin lies, told for a miss too.
enum class OriginSide : std::uint8_t { inside, on, outside };

template <Real T>
struct SphereHit {
  Status status = Status::ok;
  SphereKind kind = SphereKind::miss;
  Root root = Root::none;
  OriginSide origin = OriginSide::inside;
  /// The parameters of the hits, ascending: none for a miss, t[0] for a tangent or a lone root, t[0] and t[1] for both
  /// roots of a secant (equal where they round to one number). What is not a value is 0.
  T t[2] = {};

  /// How many values `t` holds: 0, 1 or 2.
  [[nodiscard]] constexpr int count() const noexcept {
    if (kind == SphereKind::tangent) return 1;
    if (kind != SphereKind::secant) return 0;
    return root == Root::both ? 2 : 1;
  }
  bool operator==(const SphereHit&) const = default;
};

enum class TriangleKind : std::uint8_t {
  invalid,     ///< see `status`; nothing else in the answer has a meaning
  miss,        ///< no common point
  face,        ///< one common point, inside the triangle
  edge_ab,     ///< one common point, inside the edge v = 0
  edge_bc,     ///< one common point, inside the edge u + v = 1
  edge_ca,     ///< one common point, inside the edge u = 0
  vertex_a,    ///< one common point, that corner
  vertex_b,    ///< one common point, that corner
  vertex_c,    ///< one common point, that corner
  coplanar,    ///< the ray runs in the triangle's plane and meets it
  degenerate,  ///< the triangle has no area and the ray meets it
};

/// The side the ray comes from, by the sign of d . n with n = (b - a) x (c - a): front where it is negative, back where
/// positive, none where zero. Told for a miss too.
enum class Facing : std::uint8_t { none, front, back };

template <Real T>
struct TriangleHit {
  Status status = Status::ok;
  TriangleKind kind = TriangleKind::miss;
  Facing facing = Facing::none;
  /// The common part of ray and triangle is t <= parameter <= t_end; t_end = t unless coplanar or degenerate. 0 for a miss.
  T t{}, t_end{};
  /// The hit is a + u (b - a) + v (c - a). 0 unless there is one common point of a triangle with area.
  T u{}, v{};

  /// Whether the values are an interval (t, t_end) and not a point (t, u, v).
  [[nodiscard]] constexpr bool is_interval() const noexcept {
    return kind == TriangleKind::coplanar || kind == TriangleKind::degenerate;
  }
  bool operator==(const TriangleHit&) const = default;
};

}  // namespace graze
