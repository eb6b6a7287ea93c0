// Numbers read as their bits. With denormals-are-zero on, comparisons and conversions of subnormals lie; integers do not.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "graze/numeric/platform.hpp"
#include "graze/types.hpp"

namespace graze::numeric {

template <Real T>
struct FormatOf;

template <>
struct FormatOf<float> {
  using Bits = std::uint32_t;
  static constexpr int precision = 24;         ///< bits of the significand, the hidden one included
  static constexpr int least_exponent = -149;  ///< 2^least_exponent is the least subnormal number
  static constexpr int exponent_bits = 8;
};

template <>
struct FormatOf<double> {
  using Bits = std::uint64_t;
  static constexpr int precision = 53;
  static constexpr int least_exponent = -1074;
  static constexpr int exponent_bits = 11;
};

template <Real T>
using Bits = typename FormatOf<T>::Bits;

template <Real T>
[[nodiscard]] constexpr Bits<T> bits_of(T x) noexcept {
  auto bits = std::bit_cast<Bits<T>>(x);
#if defined(__GNUC__)
  // Where these bits came from is hidden from the optimizer: clang 19 turns a test of them into a comparison of the float,
  // which denormals-are-zero falsifies.
  if (!std::is_constant_evaluated()) asm("" : "+r"(bits));
#endif
  return bits;
}

template <Real T>
inline constexpr Bits<T> sign_bit = Bits<T>(1) << (sizeof(T) * 8 - 1);

template <Real T>
inline constexpr Bits<T> infinity_bits = ((Bits<T>(1) << FormatOf<T>::exponent_bits) - 1) << (FormatOf<T>::precision - 1);

/// The bits of |x|: ordered as the magnitudes are, NaNs above infinity.
template <Real T>
[[nodiscard]] constexpr Bits<T> magnitude_bits(T x) noexcept {
  return bits_of(x) & ~sign_bit<T>;
}

template <Real T>
[[nodiscard]] constexpr bool is_finite(T x) noexcept {
  return magnitude_bits(x) < infinity_bits<T>;
}

template <Real T>
[[nodiscard]] constexpr bool is_finite(const Vec2<T>& v) noexcept {
  return is_finite(v.x) && is_finite(v.y);
}

template <Real T>
[[nodiscard]] constexpr bool is_finite(const Vec3<T>& v) noexcept {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}

template <Real T>
[[nodiscard]] constexpr bool is_zero(T x) noexcept {
  return magnitude_bits(x) == 0;
}

template <Real T>
[[nodiscard]] constexpr bool is_zero(const Vec3<T>& v) noexcept {
  return is_zero(v.x) && is_zero(v.y) && is_zero(v.z);
}

template <Real T>
[[nodiscard]] constexpr bool is_subnormal(T x) noexcept {
  constexpr Bits<T> least_normal = Bits<T>(1) << (FormatOf<T>::precision - 1);
  return magnitude_bits(x) - 1 < least_normal - 1;
}

/// x < 0, false for -0 and for NaN of either sign.
template <Real T>
[[nodiscard]] constexpr bool is_negative(T x) noexcept {
  return bits_of(x) > sign_bit<T> && magnitude_bits(x) <= infinity_bits<T>;
}

/// An integer ordered as the numbers are (no NaN), with -0 equal to +0.
template <Real T>
[[nodiscard]] constexpr std::int64_t order_key(T x) noexcept {
  const auto magnitude = static_cast<std::int64_t>(magnitude_bits(x));
  return (bits_of(x) & sign_bit<T>) != 0 ? -magnitude : magnitude;
}

}  // namespace graze::numeric
