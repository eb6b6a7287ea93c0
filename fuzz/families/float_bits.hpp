// Floating-point numbers made and stepped through as bits: the caller's rounding mode and flush-to-zero have no say.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fuzz/families/integer.hpp"
#include "graze/types.hpp"

namespace graze::fuzz::construct {

template <Real T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// Mantissa digits: 24 or 53.
template <Real T>
inline constexpr int digits = std::numeric_limits<T>::digits;

/// The exponent of the least subnormal: -149 or -1074.
template <Real T>
inline constexpr int least_exponent = std::numeric_limits<T>::min_exponent - digits<T>;

/// Every finite number is below 2 to this: 128 or 1024.
template <Real T>
inline constexpr int end_exponent = std::numeric_limits<T>::max_exponent;

template <Real T>
inline constexpr Bits<T> sign_bit = Bits<T>(1) << (sizeof(T) * 8 - 1);

template <Real T>
inline constexpr Bits<T> infinity_bits = std::bit_cast<Bits<T>>(std::numeric_limits<T>::infinity());

template <Real T>
constexpr bool is_finite(T x) {
  return (std::bit_cast<Bits<T>>(x) & ~sign_bit<T>) < infinity_bits<T>;
}

template <Real T>
constexpr bool is_zero(T x) {
  return (std::bit_cast<Bits<T>>(x) & ~sign_bit<T>) == 0;
}

/// x with its sign flipped, zero and NaN included.
template <Real T>
constexpr T negated(T x) {
  return std::bit_cast<T>(static_cast<Bits<T>>(std::bit_cast<Bits<T>>(x) ^ sign_bit<T>));
}

/// A finite number as mantissa * 2^exponent.
struct Parts {
  Int mantissa;
  int exponent;
};
template <Real T>
constexpr Parts parts(T x) {
  const Bits<T> bits = std::bit_cast<Bits<T>>(x);
  const Bits<T> magnitude_bits = bits & ~sign_bit<T>;
  const int biased = static_cast<int>(magnitude_bits >> (digits<T> - 1));
  Int mantissa = magnitude_bits & ((Bits<T>(1) << (digits<T> - 1)) - 1);
  if (biased != 0) mantissa += power_of_two(digits<T> - 1);
  return {(bits & sign_bit<T>) != 0 ? -mantissa : mantissa, least_exponent<T> + (biased > 1 ? biased - 1 : 0)};
}

/// n * 2^exponent. Where no number of the format is exactly that, the next one toward zero, and `exact` becomes false.
template <Real T>
constexpr T scaled(Int n, int exponent, bool& exact) {
  if (n == 0) return T(0);
  Int rest = magnitude(n);
  int drop = bit_length(rest) - digits<T>;
  if (exponent + drop < least_exponent<T>) drop = least_exponent<T> - exponent;
  if (drop > 0) {
    if (drop >= 127 || (rest & (power_of_two(drop) - 1)) != 0) exact = false;
    rest = drop >= 127 ? 0 : rest >> drop;
  } else {
    rest <<= -drop;
  }
  const int at = exponent + drop;  // the value is rest * 2^at, with rest < 2^digits and at >= least_exponent
  Bits<T> bits = static_cast<Bits<T>>(rest);
  if (at + digits < T >> end_exponent<T>) {
    exact = false;
    bits = infinity_bits<T> - 1;
  } else if (rest >= power_of_two(digits<T> - 1)) {
    const auto biased = static_cast<Bits<T>>(at - least_exponent<T> + 1);
    bits += (biased - 1) << (digits<T> - 1);
  }
  return std::bit_cast<T>(static_cast<Bits<T>>(n < 0 ? bits | sign_bit<T> : bits));
}

/// The number so many steps above (below where negative); stops at the largest finite numbers. Both zeros are one step.
template <Real T>
constexpr T step(T x, std::int64_t steps) {
  const Bits<T> bits = std::bit_cast<Bits<T>>(x);
  const auto rank = static_cast<std::int64_t>(bits & ~sign_bit<T>);
  const std::int64_t limit = static_cast<std::int64_t>(infinity_bits<T>) - 1;
  std::int64_t at = ((bits & sign_bit<T>) != 0 ? -rank : rank) + steps;
  if (at > limit) at = limit;
  if (at < -limit) at = -limit;
  const auto result = static_cast<Bits<T>>(at < 0 ? -at : at);
  return std::bit_cast<T>(static_cast<Bits<T>>(at < 0 ? result | sign_bit<T> : result));
}

}  // namespace graze::fuzz::construct
