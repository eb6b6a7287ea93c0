// Queries with their lengths times powers of two: exact, as long as nothing leaves the range of numbers.
#pragma once

#include <cmath>
#include <limits>

#include "fuzz/case.hpp"

namespace graze::test {

/// The exponents by which small integers, below 16, may be scaled: from the least number to the largest.
template <Real T>
inline constexpr int lowest_exponent = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
template <Real T>
inline constexpr int highest_exponent = std::numeric_limits<T>::max_exponent - 5;

template <Real T>
[[nodiscard]] Vec3<T> scaled(const Vec3<T>& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}
template <Real T>
[[nodiscard]] Ray<T> scaled(const Ray<T>& ray, int positions, int directions) {
  return {scaled(ray.origin, positions), scaled(ray.direction, directions), ray.t_min, ray.t_max};
}
template <Real T>
[[nodiscard]] Sphere<T> scaled(const Sphere<T>& sphere, int exponent) {
  return {scaled(sphere.center, exponent), std::ldexp(sphere.radius, exponent)};
}
template <Real T>
[[nodiscard]] Triangle<T> scaled(const Triangle<T>& triangle, int exponent) {
  return {scaled(triangle.a, exponent), scaled(triangle.b, exponent), scaled(triangle.c, exponent)};
}
template <Real T>
[[nodiscard]] fuzz::RaySphere<T> scaled(const fuzz::RaySphere<T>& query, int positions, int directions) {
  return {scaled(query.ray, positions, directions), scaled(query.sphere, positions)};
}
template <Real T>
[[nodiscard]] fuzz::RayTriangle<T> scaled(const fuzz::RayTriangle<T>& query, int positions, int directions) {
  return {scaled(query.ray, positions, directions), scaled(query.triangle, positions)};
}
template <Real T>
[[nodiscard]] fuzz::PointSphere<T> scaled(const fuzz::PointSphere<T>& query, int exponent) {
  return {scaled(query.point, exponent), scaled(query.sphere, exponent)};
}

}  // namespace graze::test
