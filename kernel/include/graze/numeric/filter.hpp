// The working-precision filters' common ground. A filter computes in double, whatever the inputs' precision, and knows a bound
// of its own error; what it can't tell it leaves to the exact stage.
//
// The bounds hold in every rounding mode, with flush-to-zero and denormals-are-zero, and where the compiler contracts to FMA or
// keeps excess precision:
//  - one operation errs by at most unit = 2^-52 relative (2^-53 to nearest, twice that in directed modes), contraction and
//    excess precision only err less;
//  - an operation that underflows, or an input that is read as zero, errs by at most 2^-1022 (2^-126 for a float input) more.
//    Each filter asks that its vectors' sizes lie in [low, high] of `Ordinary`; then such errors are below 2^-70 of the bound's
//    terms, which the constants' slack pays for, and nothing overflows;
//  - comparisons with NaN are false, and every test is written so that false means uncertain.
#pragma once

#include <cstdint>

#include "graze/numeric/bits.hpp"

namespace graze::numeric {

inline constexpr double unit = 0x1p-52;

/// The magnitudes that a filter takes. An infinity is above `high`.
template <Real T>
struct Ordinary;

template <>
struct Ordinary<double> {
  static constexpr double low = 0x1p-200, high = 0x1p200;
};

template <>
struct Ordinary<float> {
  static constexpr double low = 0x1p-40, high = 0x1p128;
};

template <Real T>
[[nodiscard]] inline bool is_ordinary(double least, double greatest) noexcept {
  return (least >= Ordinary<T>::low) & (greatest <= Ordinary<T>::high);
}

[[nodiscard]] inline double magnitude(double x) noexcept {
  return __builtin_fabs(x);
}

/// The second argument where one is NaN.
[[nodiscard]] inline double max(double a, double b) noexcept {
  return a > b ? a : b;
}
[[nodiscard]] inline double min(double a, double b) noexcept {
  return a < b ? a : b;
}

/// A vector in working precision.
struct Vector {
  double x, y, z;
};

template <Real T>
[[nodiscard]] inline Vector vector(const Vec3<T>& v) noexcept {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a b + c, in one rounding where the machine does that fast: filters only err less by it.
[[nodiscard]] inline double multiply_add(double a, double b, double c) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

[[nodiscard]] inline double dot(const Vector& a, const Vector& b) noexcept {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}

[[nodiscard]] inline Vector cross(const Vector& a, const Vector& b) noexcept {
  return {multiply_add(a.y, b.z, -(a.z * b.y)), multiply_add(a.z, b.x, -(a.x * b.z)), multiply_add(a.x, b.y, -(a.y * b.x))};
}

/// |x| + |y| + |z|: at least the length, and NaN or infinite where a component is.
[[nodiscard]] inline double magnitude_sum(const Vector& v) noexcept {
  return magnitude(v.x) + magnitude(v.y) + magnitude(v.z);
}

/// 0 <= t without upper end, told from the bits.
template <Real T>
[[nodiscard]] inline bool is_default_range(const Ray<T>& ray) noexcept {
  return magnitude_bits(ray.t_min) == 0 && bits_of(ray.t_max) == infinity_bits<T>;
}

/// 0, or a magnitude that a filter takes.
template <Real T>
[[nodiscard]] inline bool is_ordinary_bound(T x) noexcept {
  const auto m = magnitude_bits(x);
  return m == 0 || (m >= bits_of(static_cast<T>(Ordinary<T>::low)) && m <= bits_of(static_cast<T>(0x1p100)));
}

/// A valid range whose finite bounds a filter takes; other ranges are for the exact stage.
template <Real T>
[[nodiscard]] inline bool is_ordinary_range(const Ray<T>& ray) noexcept {
  return is_ordinary_bound(ray.t_min) &&
         (is_ordinary_bound(ray.t_max) || bits_of(ray.t_max) == infinity_bits<T>)&&order_key(ray.t_min) <= order_key(ray.t_max);
}

}  // namespace graze::numeric
