// Sixty-four leading bits of an exact value, in integers: the candidate that rounding and comparing start from.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "numeric/integer.hpp"

namespace graze::numeric {

/// sign * m * 2^exponent for a real m with |m - mantissa| <= slack; mantissa has its top bit set unless sign is 0, which
/// means exactly zero. The least significant bits of everything below are dropped, so each step's slack is counted:
/// leading bits 1, square root 2, sum 4, quotient 12 (kernel/proofs/approximation.g).
struct Approximation {
  static constexpr std::uint64_t slack = 16;

  std::uint64_t mantissa = 0;
  int exponent = 0;
  int sign = 0;
};

/// The 64 leading bits, truncated: the true mantissa is in [mantissa, mantissa + 1).
template <int N>
[[nodiscard]] inline Approximation leading(const Integer<N>& a) noexcept {
  const Integer<N> m = abs(a);
  int i = N - 1;
  while (i >= 0 && m.limb[i] == 0) --i;
  if (i < 0) return {};
  const int shift = std::countl_zero(m.limb[i]);
  const std::uint64_t below = i > 0 ? m.limb[i - 1] : 0;
  const std::uint64_t mantissa = shift == 0 ? m.limb[i] : (m.limb[i] << shift) | (below >> (64 - shift));
  return {mantissa, 64 * i - shift, a.is_negative() ? -1 : 1};
}

/// A hint of the integer x / 2^11 for a mantissa x: exact in every rounding mode.
[[nodiscard]] inline double hint(std::uint64_t mantissa) noexcept {
  return static_cast<double>(static_cast<std::int64_t>(mantissa >> 11));
}

/// The integer part of x in [2^62, 2^64).
[[nodiscard]] inline std::uint64_t to_integer(double x) noexcept {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(x * 0x1p-2)) << 2;
}

/// base + rest / d, within a unit, for |rest| < 2^79 and d >= 2^62: a double holds the step to far below a unit. Clamped to
/// [2^63, 2^64).
[[nodiscard]] inline std::uint64_t corrected(std::uint64_t base, SignedWide rest, double d) noexcept {
  const auto step = static_cast<std::int64_t>(static_cast<double>(static_cast<std::int64_t>(rest >> 16)) * 0x1p16 / d);
  const SignedWide sum = SignedWide(base) + step;
  const SignedWide top = SignedWide(~std::uint64_t(0)), bottom = SignedWide(std::uint64_t(1) << 63);
  return static_cast<std::uint64_t>(sum > top ? top : sum < bottom ? bottom : sum);
}

/// n / d for n and d within 4 units and one of them within 1; d is not zero. The relative error of the inputs is below 5 /
/// 2^63, so 10 units of the quotient, the division itself errs by 2. A double's quotient, good to 2^-50 in every rounding mode,
/// is corrected once by the remainder in integers.
[[nodiscard]] inline Approximation quotient(const Approximation& n, const Approximation& d) noexcept {
  if (n.sign == 0) return {};
  // n 2^shift / d has 64 bits.
  const int shift = n.mantissa < d.mantissa ? 64 : 63;
  const double guess = hint(n.mantissa) / hint(d.mantissa) * (shift == 64 ? 0x1p64 : 0x1p63);
  const std::uint64_t base = guess >= 0x1.fffffffffffffp63 ? ~std::uint64_t(0) : to_integer(guess);
  const auto rest = static_cast<SignedWide>((Wide(n.mantissa) << shift) - Wide(base) * d.mantissa);
  return {corrected(base, rest, hint(d.mantissa) * 0x1p11), n.exponent - d.exponent - shift, n.sign * d.sign};
}

/// The square root of a positive value known by truncated leading bits, within 2 units.
[[nodiscard]] inline Approximation square_root(const Approximation& a) noexcept {
  if (a.sign == 0) return {};
  // m 2^e = (m 2^s) 2^(e - s) with e - s even and m 2^s in [2^126, 2^128): the root has 64 bits.
  const int s = ((a.exponent & 1) == 0) ? 64 : 63;
  const Wide x = Wide(a.mantissa) << s;
  // As in `quotient`: a double's root, corrected by one Newton step in integers.
  const double guess = std::sqrt(hint(a.mantissa)) * (s == 64 ? 0x1.6a09e667f3bcdp37 : 0x1p37);
  const std::uint64_t base = guess >= 0x1.fffffffffffffp63 ? ~std::uint64_t(0) : to_integer(guess);
  const auto rest = static_cast<SignedWide>(x - Wide(base) * base);
  return {corrected(base, rest, 2 * guess), (a.exponent - s) / 2, 1};
}

/// |a| + |b| with a's sign; the error in units is at most the larger of the two plus two.
[[nodiscard]] inline Approximation add_magnitudes(Approximation a, Approximation b) noexcept {
  if (b.sign == 0) return a;
  const int sign = a.sign == 0 ? 1 : a.sign;
  if (a.sign == 0) return {b.mantissa, b.exponent, sign};
  if (a.exponent < b.exponent) std::swap(a, b);
  const int gap = a.exponent - b.exponent;
  const Wide sum = Wide(a.mantissa) + (gap < 64 ? b.mantissa >> gap : 0);
  if ((sum >> 64) == 0) return {static_cast<std::uint64_t>(sum), a.exponent, sign};
  return {static_cast<std::uint64_t>(sum >> 1), a.exponent + 1, sign};
}

/// Where the exact value lies against a dyadic number: -1 below, 1 above, 0 too close to tell (or both zero).
[[nodiscard]] inline int compare(const Approximation& a, const Dyadic& x) noexcept {
  if (a.sign != x.sign()) return a.sign < x.sign() ? -1 : 1;
  if (a.sign == 0) return 0;
  const int shift = std::countl_zero(x.mantissa);
  const std::uint64_t mantissa = x.mantissa << shift;
  const int gap = a.exponent - (x.exponent - shift);
  if (gap > 1 || gap < -1) return gap > 0 ? a.sign : -a.sign;
  // In units of the lesser exponent; the slack of a doubles if it is a that is shifted.
  const Wide left = Wide(a.mantissa) << (gap > 0 ? 1 : 0);
  const Wide right = Wide(mantissa) << (gap < 0 ? 1 : 0);
  const Wide slack = Approximation::slack * 2;
  if (left > right + slack) return a.sign;
  if (right > left + slack) return -a.sign;
  return 0;
}

}  // namespace graze::numeric
