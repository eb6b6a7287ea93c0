// How near a case is to a boundary, in exact rationals: whether one of the numbers whose signs decide is within so many ulps of
// zero, relative to the sum of the magnitudes that it is made of.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <variant>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// A value with the sum of the magnitudes of its terms.
struct Weighed {
  mpq_class value, weight;

  [[nodiscard]] bool is_near_zero(int bits) const {
    mpq_class scaled = abs(value);
    mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
    return scaled <= weight;
  }
};
inline Weighed weighed(mpq_class value) {
  mpq_class weight = abs(value);
  return {std::move(value), std::move(weight)};
}
inline Weighed operator+(const Weighed& a, const Weighed& b) {
  return {a.value + b.value, a.weight + b.weight};
}
inline Weighed operator-(const Weighed& a, const Weighed& b) {
  return {a.value - b.value, a.weight + b.weight};
}
inline Weighed operator*(const Weighed& a, const Weighed& b) {
  return {a.value * b.value, a.weight * b.weight};
}

using WeighedVec = std::array<Weighed, 3>;

template <Real T>
WeighedVec weighed(const Vec3<T>& v) {
  return {weighed(mpq_class(v.x)), weighed(mpq_class(v.y)), weighed(mpq_class(v.z))};
}
/// The exact difference, taken as one number.
template <Real T>
WeighedVec difference(const Vec3<T>& p, const Vec3<T>& q) {
  return {weighed(mpq_class(p.x) - mpq_class(q.x)), weighed(mpq_class(p.y) - mpq_class(q.y)),
          weighed(mpq_class(p.z) - mpq_class(q.z))};
}
inline Weighed dot(const WeighedVec& p, const WeighedVec& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline WeighedVec cross(const WeighedVec& p, const WeighedVec& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// D, B and C of the contract.
template <Real T>
bool is_near_boundary(const RaySphere<T>& input, int bits) {
  const WeighedVec d = weighed(input.ray.direction);
  const WeighedVec l = difference(input.sphere.center, input.ray.origin);
  const Weighed squared_radius = weighed(mpq_class(input.sphere.radius) * mpq_class(input.sphere.radius));
  const WeighedVec across = cross(d, l);
  const Weighed discriminant = dot(d, d) * squared_radius - weighed(dot(across, across).value);
  return discriminant.is_near_zero(bits) || (dot(l, l) - squared_radius).is_near_zero(bits) || dot(d, l).is_near_zero(bits);
}

/// The signs of the edges, of the plane and of d.n.
template <Real T>
bool is_near_boundary(const RayTriangle<T>& input, int bits) {
  const WeighedVec d = weighed(input.ray.direction);
  const auto& [a, b, c] = input.triangle;
  const WeighedVec p = difference(a, input.ray.origin);
  const WeighedVec q = difference(b, input.ray.origin);
  const WeighedVec r = difference(c, input.ray.origin);
  const WeighedVec normal = cross(difference(b, a), difference(c, a));
  return dot(d, cross(p, q)).is_near_zero(bits) || dot(d, cross(q, r)).is_near_zero(bits) ||
         dot(d, cross(r, p)).is_near_zero(bits) || dot(d, normal).is_near_zero(bits) || dot(p, normal).is_near_zero(bits);
}

template <Real T>
bool is_near_boundary(const PointLine<T>& input, int bits) {
  const auto& [point, line] = input;
  return (weighed(mpq_class(line.a) * mpq_class(point.x)) + weighed(mpq_class(line.b) * mpq_class(point.y)) +
          weighed(mpq_class(line.c)))
      .is_near_zero(bits);
}
template <Real T>
bool is_near_boundary(const PointPlane<T>& input, int bits) {
  const auto& [point, plane] = input;
  const Vec3<T> normal{plane.a, plane.b, plane.c};
  return (dot(weighed(normal), weighed(point)) + weighed(mpq_class(plane.d))).is_near_zero(bits);
}
template <Real T>
bool is_near_boundary(const PointSphere<T>& input, int bits) {
  const WeighedVec l = difference(input.point, input.sphere.center);
  const Weighed squared_radius = weighed(mpq_class(input.sphere.radius) * mpq_class(input.sphere.radius));
  return (dot(l, l) - squared_radius).is_near_zero(bits);
}

template <Real T>
bool is_near_boundary(const Case<T>& input, int bits) {
  return std::visit([&](const auto& query) { return is_near_boundary(query, bits); }, input);
}

}  // namespace graze::fuzz
