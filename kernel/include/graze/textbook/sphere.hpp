// Ray and sphere by the quadratic A t^2 + B t + C = 0, in three forms of its solution: naive, stable, repaired.
// All three decide by the computed discriminant and share its failures: near a tangent its sign is noise, far from a small
// sphere the squares in C cancel and the sphere is lost or grows, large numbers overflow to misses or to roots at infinity,
// small ones underflow to tangents, and a zero may come out as -0. No input is validated; an infinity or a NaN gives some
// answer without a meaning.
#pragma once

#include <cmath>

#include "graze/answer.hpp"
#include "graze/textbook/vector.hpp"
#include "graze/types.hpp"

namespace graze::textbook {

/// a t^2 + b t + c.
template <Real T>
struct Quadratic {
  T a{}, b{}, c{};
};

/// Both roots as computed, first <= second where neither is NaN. They are NaN where the discriminant is negative.
template <Real T>
struct Roots {
  T first{}, second{};
};

/// The quadratic whose roots are the parameters of the crossings: f(e + t d) for the sphere's implicit form f.
/// c is f(e), so its sign says where the origin lies.
template <Real T>
[[nodiscard]] constexpr Quadratic<T> quadratic(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  const Vec3<T> from_center = difference(ray.origin, sphere.center);
  return {dot(ray.direction, ray.direction), 2 * dot(ray.direction, from_center),
          dot(from_center, from_center) - sphere.radius * sphere.radius};
}

/// B^2 - 4 A C: negative for no root, 0 for a double one, positive for two, as far as its rounding can be trusted.
template <Real T>
[[nodiscard]] constexpr T discriminant(const Quadratic<T>& q) noexcept {
  return q.b * q.b - 4 * q.a * q.c;
}

namespace detail {

/// Both ends belong to the range; NaN does not.
template <Real T>
[[nodiscard]] constexpr bool in_range(const Ray<T>& ray, T t) noexcept {
  return ray.t_min <= t && t <= ray.t_max;
}

template <Real T>
[[nodiscard]] constexpr Roots<T> ascending(T s, T t) noexcept {
  return s > t ? Roots<T>{t, s} : Roots<T>{s, t};
}

/// The roots by q = -(B + sign sqrt(D)) / 2: q / A and C / q.
template <Real T>
[[nodiscard]] Roots<T> roots_by_q(const Quadratic<T>& q, T sign) noexcept {
  const T shared = -(q.b + sign * std::sqrt(discriminant(q))) / 2;
  return ascending(shared / q.a, q.c / shared);
}

/// The tangent at t; a miss where t lies outside the range.
template <Real T>
[[nodiscard]] constexpr SphereHit<T> hit_of_double_root(const Ray<T>& ray, OriginSide origin, T t) noexcept {
  SphereHit<T> hit;
  hit.origin = origin;
  if (!in_range(ray, t)) return hit;
  hit.kind = SphereKind::tangent;
  hit.root = Root::both;
  hit.t[0] = t;
  return hit;
}

/// The secant with those of the roots that lie in the range; a miss where none does.
template <Real T>
[[nodiscard]] constexpr SphereHit<T> hit_of_roots(const Ray<T>& ray, OriginSide origin, const Roots<T>& t) noexcept {
  SphereHit<T> hit;
  hit.origin = origin;
  const bool first = in_range(ray, t.first);
  const bool second = in_range(ray, t.second);
  if (!first && !second) return hit;
  hit.kind = SphereKind::secant;
  hit.root = first && second ? Root::both : first ? Root::first : Root::second;
  hit.t[0] = first ? t.first : t.second;
  if (first && second) hit.t[1] = t.second;
  return hit;
}

/// The answer by the computed numbers, `roots` being the form of the solution.
template <Real T, class RootsOf>
[[nodiscard]] SphereHit<T> intersect_by(const Ray<T>& ray, const Sphere<T>& sphere, RootsOf roots) noexcept {
  const Quadratic<T> q = quadratic(ray, sphere);
  SphereHit<T> hit;
  hit.origin = q.c < 0 ? OriginSide::inside : q.c > 0 ? OriginSide::outside : OriginSide::on;
  const T d = discriminant(q);
  if (d < 0) return hit;
  if (d == 0) return hit_of_double_root(ray, hit.origin, -q.b / (2 * q.a));
  return hit_of_roots(ray, hit.origin, roots(q));
}

/// intersect_by(ray, sphere, roots by q).kind != miss, with early exits; the roots need no order for that.
template <Real T, class Sgn>
[[nodiscard]] bool hits_by_q(const Ray<T>& ray, const Sphere<T>& sphere, Sgn sgn) noexcept {
  const Quadratic<T> q = quadratic(ray, sphere);
  const T d = discriminant(q);
  if (d < 0) return false;
  if (d == 0) return in_range(ray, -q.b / (2 * q.a));
  const T shared = -(q.b + sgn(q.b) * std::sqrt(d)) / 2;
  return in_range(ray, shared / q.a) || in_range(ray, q.c / shared);
}

}  // namespace detail

/// t = (-B -+ sqrt(D)) / 2A.
/// Fails where B^2 is much larger than 4 A C: B and sqrt(D) agree in their leading digits, and the root near 0 is what rounding
/// left of their difference, no digit of which need be right (Goldberg, "What every computer scientist should know about
/// floating-point arithmetic", section 1.4).
/// Source: Shirley, Marschner, "Fundamentals of Computer Graphics", section 4.4.1.
namespace naive {

template <Real T>
[[nodiscard]] Roots<T> roots(const Quadratic<T>& q) noexcept {
  const T root = std::sqrt(discriminant(q));
  return {(-q.b - root) / (2 * q.a), (-q.b + root) / (2 * q.a)};
}

template <Real T>
[[nodiscard]] SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return detail::intersect_by(ray, sphere, [](const Quadratic<T>& q) { return roots(q); });
}

/// intersect(ray, sphere).kind != miss, with early exits.
template <Real T>
[[nodiscard]] bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  const Quadratic<T> q = quadratic(ray, sphere);
  const T d = discriminant(q);
  if (d < 0) return false;
  const T root = std::sqrt(d);
  return detail::in_range(ray, (-q.b - root) / (2 * q.a)) || detail::in_range(ray, (-q.b + root) / (2 * q.a));
}

}  // namespace naive

/// q = -(B + sgn(B) sqrt(D)) / 2, t1 = q / A, t2 = C / q: the numbers that are added have one sign, so nothing cancels.
/// Equivalently q = -(B + sgn(B) sqrt(D)), t1 = q / 2A, t2 = 2C / q; mixing the two halves one root and doubles the other.
/// Fails at B = 0, where sgn(0) = 0 as usual makes q = -0: t1 = -0, and t2 = C / -0 is an infinity, or NaN for C = 0. The true
/// roots, -+sqrt(-C / A), are both lost: a ray that starts at the sphere's center answers 0 and infinity.
/// Source: Press et al., "Numerical Recipes", section 5.6.
namespace stable {

template <Real T>
[[nodiscard]] constexpr T sgn(T x) noexcept {
  return T((x > 0) - (x < 0));
}

template <Real T>
[[nodiscard]] Roots<T> roots(const Quadratic<T>& q) noexcept {
  return detail::roots_by_q(q, sgn(q.b));
}

template <Real T>
[[nodiscard]] SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return detail::intersect_by(ray, sphere, [](const Quadratic<T>& q) { return roots(q); });
}

/// intersect(ray, sphere).kind != miss, with early exits.
template <Real T>
[[nodiscard]] bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return detail::hits_by_q(ray, sphere, [](T b) { return sgn(b); });
}

}  // namespace stable

/// The stable form with sgn(0) = 1, so that q = -sqrt(D) / 2 at B = 0 and both roots are there.
/// Fails as every form here does, by its computed discriminant and by overflow and underflow: B^2 - 4AC still cancels near a
/// tangent.
namespace repaired {

template <Real T>
[[nodiscard]] constexpr T sgn(T x) noexcept {
  return x < 0 ? T(-1) : T(1);
}

template <Real T>
[[nodiscard]] Roots<T> roots(const Quadratic<T>& q) noexcept {
  return detail::roots_by_q(q, sgn(q.b));
}

template <Real T>
[[nodiscard]] SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return detail::intersect_by(ray, sphere, [](const Quadratic<T>& q) { return roots(q); });
}

/// intersect(ray, sphere).kind != miss, with early exits.
template <Real T>
[[nodiscard]] bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  return detail::hits_by_q(ray, sphere, [](T b) { return sgn(b); });
}

}  // namespace repaired
}  // namespace graze::textbook
