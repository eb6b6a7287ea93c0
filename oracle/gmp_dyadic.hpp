// Floating-point numbers taken apart by their bits: no floating-point operation touches an input of the GMP oracle.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <type_traits>

#include "graze/types.hpp"

namespace graze::oracle::gmp {

/// The layout of a binary interchange format.
template <Real T>
struct Format {
  using Bits = std::conditional_t<std::same_as<T, double>, std::uint64_t, std::uint32_t>;
  static constexpr int kDigits = std::numeric_limits<T>::digits;                 ///< of the significand: 53, 24
  static constexpr int kMaxExponent = std::numeric_limits<T>::max_exponent - 1;  ///< largest e with 2^e finite: 1023, 127
  static constexpr int kMinUlp =
      std::numeric_limits<T>::min_exponent - kDigits;               ///< 2^kMinUlp is the least number: -1074, -149
  static constexpr Bits kSignBit = Bits(1) << (8 * sizeof(T) - 1);  ///< 1 for negative numbers
  static constexpr Bits kInfinity = Bits(2 * kMaxExponent + 1) << (kDigits - 1);  ///< the bits of +infinity
  static constexpr Bits kFraction = (Bits(1) << (kDigits - 1)) - 1;               ///< the stored part of the significand
};

/// An integer that orders finite numbers and infinities as their values are ordered; 0 for both zeros.
template <Real T>
[[nodiscard]] std::int64_t order(T x) {
  using F = Format<T>;
  const auto bits = std::bit_cast<typename F::Bits>(x);
  const auto magnitude = static_cast<std::int64_t>(bits & ~F::kSignBit);
  return (bits & F::kSignBit) != 0 ? -magnitude : magnitude;
}

/// Neither a NaN nor an infinity.
template <Real T>
[[nodiscard]] bool is_finite(T x) {
  return std::abs(order(x)) < static_cast<std::int64_t>(Format<T>::kInfinity);
}

/// mantissa * 2^exponent. The mantissa is odd, or else 0 with an exponent that never sets a common unit.
struct Dyadic {
  static constexpr int kZeroExponent = std::numeric_limits<int>::max();
  std::int64_t mantissa = 0;
  int exponent = kZeroExponent;
};

/// A finite number as it is, exactly.
template <Real T>
[[nodiscard]] Dyadic dyadic(T x) {
  using F = Format<T>;
  const std::int64_t key = order(x);
  if (key == 0) return {};
  const auto magnitude = static_cast<typename F::Bits>(std::abs(key));
  const auto field = static_cast<int>(magnitude >> (F::kDigits - 1));
  auto mantissa = static_cast<std::int64_t>(magnitude & F::kFraction);
  if (field != 0) mantissa |= static_cast<std::int64_t>(F::kFraction) + 1;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa >>= zeros;
  return {key < 0 ? -mantissa : mantissa, F::kMinUlp + std::max(field - 1, 0) + zeros};
}

/// The exponent of the coarsest power of two that divides all the numbers; 0 where all are zero.
[[nodiscard]] inline int common_unit(std::initializer_list<Dyadic> numbers) {
  int unit = Dyadic::kZeroExponent;
  for (const Dyadic& x : numbers) unit = std::min(unit, x.exponent);
  return unit == Dyadic::kZeroExponent ? 0 : unit;
}

static_assert(sizeof(long) == sizeof(std::int64_t), "GMP takes a mantissa as a long");

/// out = x / 2^unit, where 2^unit divides x.
inline void scale(mpz_class& out, const Dyadic& x, int unit) {
  mpz_set_si(out.get_mpz_t(), x.mantissa);
  if (x.mantissa != 0) mpz_mul_2exp(out.get_mpz_t(), out.get_mpz_t(), static_cast<mp_bitcnt_t>(x.exponent - unit));
}

}  // namespace graze::oracle::gmp
