// The common part of a ray and a flat set in one line or plane with it: an interval of exact quotients, clipped to the range.
#pragma once

#include "exact/quotient.hpp"
#include "exact/range.hpp"

namespace graze::exact {

/// One end of the common part, as bits of the format.
struct IntervalBits {
  bool empty = true;
  std::uint64_t first = 0, last = 0;
};

/// The bits of a bound that is itself the end of the interval; it is a number of the format, so nothing is rounded.
[[nodiscard]] inline std::uint64_t bound_bits(const Dyadic& x, const numeric::Format& format) noexcept {
  if (x.is_zero()) return 0;
  const int normal_unit = x.top() - format.precision;
  const int unit = normal_unit > format.least_exponent ? normal_unit : format.least_exponent;
  const std::uint64_t kept = x.mantissa << (x.exponent - unit);
  const std::uint64_t bits = (static_cast<std::uint64_t>(unit - format.least_exponent) << (format.precision - 1)) + kept;
  return x.negative ? bits | (std::uint64_t(1) << (format.exponent_bits + format.precision - 1)) : bits;
}

/// first <= last, both of one scale. `rounded` is false where only emptiness is asked for.
template <int N>
[[nodiscard]] inline IntervalBits clip(const Quotient<N>& first, const Quotient<N>& last, const Range& range,
                                       const numeric::Format& format, bool rounded) noexcept {
  if (range.starts_after(last) || range.ends_before(first)) return {};
  if (!rounded) return {false};
  IntervalBits out{false};
  out.first = range.starts_after(first) ? bound_bits(range.t_min, format) : round_to_bits(first, format);
  out.last = range.ends_before(last) ? bound_bits(range.t_max, format) : round_to_bits(last, format);
  return out;
}

}  // namespace graze::exact
