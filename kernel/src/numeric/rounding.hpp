// Exact values rounded to a format and compared with its numbers, without a precision loop: the 64 leading bits decide nearly
// always; where they do not, the exact sign at one dyadic number next to the value does.
#pragma once

#include <cstdint>

#include "numeric/approximation.hpp"

namespace graze::numeric {

/// The format that a result is rounded to.
struct Format {
  int precision;
  int least_exponent;
  int exponent_bits;
};

template <Real T>
inline constexpr Format format_of{FormatOf<T>::precision, FormatOf<T>::least_exponent, FormatOf<T>::exponent_bits};

/// An exact real value has
///  - `sign()`;
///  - `approximation()`, its leading bits;
///  - `compare_near(x)`, the exact sign of value - x for a dyadic x of at most 54 bits that the approximation cannot tell from
///  the
///    value, neither of them zero.
template <class Value>
[[nodiscard]] inline int compare(const Value& value, const Dyadic& x) noexcept {
  const int sign = value.sign();
  if (sign != x.sign()) return sign < x.sign() ? -1 : 1;
  if (sign == 0) return 0;
  const int order = compare(value.approximation(), x);
  return order != 0 ? order : value.compare_near(x);
}

/// The number of the format nearest to the value, ties to even: its bits. Subnormal results and overflow to infinity
/// included; what is or rounds to zero is +0.
template <class Value>
[[nodiscard]] inline std::uint64_t round_to_bits(const Value& value, const Format& format) noexcept {
  const Approximation a = value.approximation();
  if (a.sign == 0) return 0;
  // The last place of the result: 2^unit, so that value = kept units and a rest.
  const int normal_unit = a.exponent + 64 - format.precision;
  const int unit = normal_unit > format.least_exponent ? normal_unit : format.least_exponent;
  const int shift = unit - a.exponent;
  if (shift > 66) return 0;  // below a quarter of the least subnormal number
  const Wide rest = Wide(a.mantissa) & ((Wide(1) << shift) - 1);
  const Wide half = Wide(1) << (shift - 1);
  std::uint64_t kept = shift < 64 ? a.mantissa >> shift : 0;
  bool up = rest > half;
  if ((up ? rest - half : half - rest) <= Approximation::slack) {
    const int side = a.sign * value.compare_near({2 * kept + 1, unit - 1, a.sign < 0});
    up = side > 0 || (side == 0 && (kept & 1) != 0);
  }
  kept += up ? 1 : 0;
  if (kept == 0) return 0;
  // A carry out of the significand moves into the exponent field by itself.
  const int fraction_bits = format.precision - 1;
  const std::uint64_t infinity = ((std::uint64_t(1) << format.exponent_bits) - 1) << fraction_bits;
  const std::int64_t field = std::int64_t(unit) - format.least_exponent;
  std::uint64_t bits = infinity;
  if (field < (std::int64_t(1) << format.exponent_bits)) {
    bits = (static_cast<std::uint64_t>(field) << fraction_bits) + kept;
    if (bits > infinity) bits = infinity;
  }
  const std::uint64_t sign = std::uint64_t(1) << (format.exponent_bits + fraction_bits);
  return a.sign < 0 ? bits | sign : bits;
}

}  // namespace graze::numeric
