// The working-precision filters' common ground. A filter computes in a precision W, double or the inputs' own, and knows a
// bound of its own error; what it can't tell it leaves to the next stage: of floats to the filter in double, of that to
// integers.
//
// The bounds hold in every rounding mode, with flush-to-zero and denormals-are-zero, and where the compiler contracts to FMA or
// keeps excess precision:
//  - one operation errs by at most unit = 2^-52 relative (2^-53 to nearest, twice that in directed modes; in float 2^-23),
//    also where it is contracted or has excess precision;
//  - an operation that underflows, or an input that is read as zero, errs by at most 2^-1022 (2^-126 for a float) more.
//    Each filter asks that its vectors' sizes lie in [low, high] of `Ordinary`; then such errors are below 2^-80 of the bound's
//    terms (in float, 2^-39), which the constants' slack pays for, and nothing overflows;
//  - comparisons with NaN are false, and every test is written so that false means uncertain.
// Each constant is proven in kernel/proofs, this model in rounding.g, and held equal to the one there by a test.
#pragma once

#include <cstdint>

#include "graze/numeric/bits.hpp"

namespace graze::numeric {

template <class W>
inline constexpr W unit_of = sizeof(W) < sizeof(double) ? W(0x1p-23) : W(0x1p-52);

inline constexpr double unit = unit_of<double>;

/// The magnitudes that a filter in W takes of inputs in T: of vectors, from `low` to `high`, an infinity being above; of a
/// bound of the ray's range, 0 or from `low` to `bound_high`.
template <class W, Real T>
struct Ordinary;

template <>
struct Ordinary<double, double> {
  static constexpr double low = 0x1p-200, high = 0x1p200, bound_high = 0x1p100;
};

template <>
struct Ordinary<double, float> {
  static constexpr double low = 0x1p-40, high = 0x1p128, bound_high = 0x1p100;
};

template <>
struct Ordinary<float, float> {
  static constexpr float low = 0x1p-20F, high = 0x1p30F, bound_high = 0x1p30F;
};

template <class W, Real T>
[[nodiscard]] inline bool is_ordinary(W least, W greatest) noexcept {
  return (least >= Ordinary<W, T>::low) & (greatest <= Ordinary<W, T>::high);
}

[[nodiscard]] inline double magnitude(double x) noexcept {
  return __builtin_fabs(x);
}
[[nodiscard]] inline float magnitude(float x) noexcept {
  return __builtin_fabsf(x);
}

[[nodiscard]] inline double square_root(double x) noexcept {
  return __builtin_sqrt(x);
}
[[nodiscard]] inline float square_root(float x) noexcept {
  return __builtin_sqrtf(x);
}

/// The second argument where one is NaN.
template <class W>
[[nodiscard]] inline W min(W a, W b) noexcept {
  return a < b ? a : b;
}

/// A vector in working precision.
template <class W>
struct Vector {
  W x, y, z;
};

template <class W, Real T>
[[nodiscard]] inline Vector<W> vector(const Vec3<T>& v) noexcept {
  return {static_cast<W>(v.x), static_cast<W>(v.y), static_cast<W>(v.z)};
}

template <class W>
[[nodiscard]] inline Vector<W> operator-(const Vector<W>& a, const Vector<W>& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// a b + c, in one rounding where the machine does that fast: filters only err less by it.
template <class W>
[[nodiscard]] inline W multiply_add(W a, W b, W c) noexcept {
#if defined(__FMA__) || defined(__aarch64__)
  if constexpr (sizeof(W) < sizeof(double)) return __builtin_fmaf(a, b, c);
  return __builtin_fma(a, b, c);
#else
  return a * b + c;
#endif
}

template <class W>
[[nodiscard]] inline W dot(const Vector<W>& a, const Vector<W>& b) noexcept {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}

template <class W>
[[nodiscard]] inline Vector<W> cross(const Vector<W>& a, const Vector<W>& b) noexcept {
  return {multiply_add(a.y, b.z, -(a.z * b.y)), multiply_add(a.z, b.x, -(a.x * b.z)), multiply_add(a.x, b.y, -(a.y * b.x))};
}

/// |x| + |y| + |z|: at least the length, and NaN or infinite where a component is.
template <class W>
[[nodiscard]] inline W magnitude_sum(const Vector<W>& v) noexcept {
  return magnitude(v.x) + magnitude(v.y) + magnitude(v.z);
}

/// 0 <= t without upper end, told from the bits.
template <Real T>
[[nodiscard]] inline bool is_default_range(const Ray<T>& ray) noexcept {
  return magnitude_bits(ray.t_min) == 0 && bits_of(ray.t_max) == infinity_bits<T>;
}

/// 0, or a magnitude that a filter in W takes.
template <class W, Real T>
[[nodiscard]] inline bool is_ordinary_bound(T x) noexcept {
  using Limits = Ordinary<W, T>;
  const auto m = magnitude_bits(x);
  return m == 0 || (m >= bits_of(static_cast<T>(Limits::low)) && m <= bits_of(static_cast<T>(Limits::bound_high)));
}

/// A valid range whose finite bounds a filter in W takes; other ranges are for the exact stage.
template <class W, Real T>
[[nodiscard]] inline bool is_ordinary_range(const Ray<T>& ray) noexcept {
  if (!is_ordinary_bound<W>(ray.t_min)) return false;
  return (is_ordinary_bound<W>(ray.t_max) || bits_of(ray.t_max) == infinity_bits<T>)&&order_key(ray.t_min) <=
         order_key(ray.t_max);
}

}  // namespace graze::numeric
