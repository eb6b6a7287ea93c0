// Floating-point numbers as what they are: a sign, an integer and a power of two. Read from the bits, so that no rounding
// mode, flush-to-zero or denormals-are-zero can touch it.
#pragma once

#include <bit>
#include <cstdint>

#include "graze/numeric/bits.hpp"

namespace graze::numeric {

/// (negative ? -1 : 1) * mantissa * 2^exponent; mantissa is odd, or 0 for zero.
struct Dyadic {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool negative = false;

  [[nodiscard]] constexpr bool is_zero() const noexcept { return mantissa == 0; }
  [[nodiscard]] constexpr int sign() const noexcept { return mantissa == 0 ? 0 : negative ? -1 : 1; }
  /// One more than the exponent of the leading bit.
  [[nodiscard]] constexpr int top() const noexcept { return exponent + std::bit_width(mantissa); }
};

/// The dyadic number that a finite x stands for. Without branches: data with zeros in it is not predictable.
template <Real T>
[[nodiscard]] constexpr Dyadic dyadic(T x) noexcept {
  using Format = FormatOf<T>;
  const std::uint64_t magnitude = magnitude_bits(x);
  const int fraction_bits = Format::precision - 1;
  const auto field = static_cast<int>(magnitude >> fraction_bits);
  const std::uint64_t fraction = magnitude & ((std::uint64_t(1) << fraction_bits) - 1);
  const std::uint64_t mantissa = fraction | (static_cast<std::uint64_t>(field != 0) << fraction_bits);
  const int trailing = std::countr_zero(mantissa) & 63;
  return {mantissa >> trailing, Format::least_exponent + field - (field != 0) + trailing, (bits_of(x) & sign_bit<T>) != 0};
}

struct DyadicVec3 {
  Dyadic x, y, z;
};

template <Real T>
[[nodiscard]] constexpr DyadicVec3 dyadic(const Vec3<T>& v) noexcept {
  return {dyadic(v.x), dyadic(v.y), dyadic(v.z)};
}

/// The span of bit positions that a set of numbers uses: they are integers of `width()` bits in units of 2^low.
struct Extent {
  static constexpr int none = 1 << 20;
  int low = none, high = -none;

  constexpr void include(const Dyadic& d) noexcept {
    const int bottom = d.is_zero() ? none : d.exponent, top = d.is_zero() ? -none : d.top();
    low = bottom < low ? bottom : low;
    high = top > high ? top : high;
  }
  constexpr void include(const DyadicVec3& v) noexcept {
    include(v.x);
    include(v.y);
    include(v.z);
  }
  /// Not positive for a set of zeros.
  [[nodiscard]] constexpr int width() const noexcept { return high - low; }
};

}  // namespace graze::numeric
