// What decisions by short integers have in common: inputs as integers of 64 bits in steps of their lattice.
#pragma once

#include <cstdint>

#include "graze/numeric/filter.hpp"
#include "numeric/lattice.hpp"

namespace graze::predicates {

using numeric::Lattice;
using numeric::Vector;

/// Integers of 128 bits where the compiler has them, on machines of 64 bits; elsewhere there is no such stage.
#if defined(__SIZEOF_INT128__)
#define GRAZE_HAS_SHORT_INTEGERS 1
__extension__ typedef __int128 Wide;

struct ShortVec3 {
  std::int64_t x, y, z;
};

/// In steps of the lattice.
[[nodiscard]] inline ShortVec3 short_vec3(const Lattice& lattice, const Vector<double>& v) noexcept {
  return {lattice.in_steps(v.x), lattice.in_steps(v.y), lattice.in_steps(v.z)};
}

[[nodiscard]] inline ShortVec3 cross(const ShortVec3& a, const ShortVec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline std::int64_t dot(const ShortVec3& a, const ShortVec3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Wide wide_product(std::int64_t a, std::int64_t b) noexcept {
  return static_cast<Wide>(a) * b;
}
[[nodiscard]] inline Wide wide_dot(const ShortVec3& a, const ShortVec3& b) noexcept {
  return wide_product(a.x, b.x) + wide_product(a.y, b.y) + wide_product(a.z, b.z);
}
#else
#define GRAZE_HAS_SHORT_INTEGERS 0
#endif

/// Whether the caller has set flush-to-zero or denormals-are-zero, asked of the arithmetic itself: by a sum, in which subnormal
/// numbers cost processors nothing.
[[nodiscard]] inline bool flushes_subnormals() noexcept {
  static const volatile double subnormal = 0x1p-1050;
  const double x = subnormal;
  return numeric::bits_of(x + x) == 0;
}

[[nodiscard]] inline bool has_subnormal(const Vec3<float>& v) noexcept {
  return numeric::is_subnormal(v.x) || numeric::is_subnormal(v.y) || numeric::is_subnormal(v.z);
}

/// Whether a number is converted to zero that is not. The lattice sees a double that is read as zero, but of a float only what
/// it has become in double.
template <class Shape>
[[nodiscard]] inline bool is_hidden(const Ray<double>&, const Shape&) noexcept {
  return false;
}
[[nodiscard]] inline bool is_hidden(const Ray<float>& ray, const Triangle<float>& triangle) noexcept {
  return flushes_subnormals() && (has_subnormal(ray.origin) || has_subnormal(ray.direction) || has_subnormal(triangle.a) ||
                                  has_subnormal(triangle.b) || has_subnormal(triangle.c));
}
[[nodiscard]] inline bool is_hidden(const Ray<float>& ray, const Sphere<float>& sphere) noexcept {
  return flushes_subnormals() && (has_subnormal(ray.origin) || has_subnormal(ray.direction) || has_subnormal(sphere.center) ||
                                  numeric::is_subnormal(sphere.radius));
}

}  // namespace graze::predicates
