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
/// leading bits 1, square root 2, sum 4, quotient 12.
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

/// n / d for truncated leading bits; d is not zero. The relative error of each input is below 2^-63, the division drops less
/// than one unit: at most 1 + 2 (2 + 2) units of a mantissa that was shifted by up to one bit.
[[nodiscard]] inline Approximation quotient(const Approximation& n, const Approximation& d) noexcept {
  if (n.sign == 0) return {};
  const bool less = n.mantissa < d.mantissa;
  // With n < d the quotient n 2^64 / d has 64 bits; otherwise n 2^63 / d has.
  const Wide dividend = less ? Wide(n.mantissa) << 64 : Wide(n.mantissa) << 63;
  const auto q = static_cast<std::uint64_t>(dividend / d.mantissa);
  return {q, n.exponent - d.exponent - (less ? 64 : 63), n.sign * d.sign};
}

/// The square root of a positive value known by truncated leading bits, within 2 units.
[[nodiscard]] inline Approximation square_root(const Approximation& a) noexcept {
  if (a.sign == 0) return {};
  // m 2^e = (m 2^s) 2^(e - s) with e - s even and m 2^s in [2^126, 2^128): the root has 64 bits.
  const int s = ((a.exponent & 1) == 0) ? 64 : 63;
  const Wide x = Wide(a.mantissa) << s;
  // A double's root is a hint, good to 2^-51 in every rounding mode; one Newton step in integers makes it good to a unit.
  const double hint = std::sqrt(static_cast<double>(a.mantissa)) * (s == 64 ? 0x1p32 : 0x1.6a09e667f3bcdp31);
  const std::uint64_t r = hint >= 0x1.fffffffffffffp63 ? ~std::uint64_t(0) : static_cast<std::uint64_t>(hint);
  const auto rest = static_cast<SignedWide>(x - Wide(r) * r);
  // |rest| < 2^79 and |step| < 2^15: a double holds the step to far below a unit.
  const auto step = static_cast<std::int64_t>(static_cast<double>(rest) / (2 * static_cast<double>(r)));
  const SignedWide root = SignedWide(r) + step;
  const SignedWide top = SignedWide(~std::uint64_t(0)), bottom = SignedWide(std::uint64_t(1) << 63);
  const auto clamped = static_cast<std::uint64_t>(root > top ? top : root < bottom ? bottom : root);
  return {clamped, (a.exponent - s) / 2, 1};
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
