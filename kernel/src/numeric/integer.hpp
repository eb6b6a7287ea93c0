// Integers of fixed width on the stack, two's complement, wrapping modulo 2^(64 N). Sums and products may wrap on the way: a
// result is right whenever its true value fits its width, and each use says why it does.
#pragma once

#include <bit>
#include <cstdint>

#include "numeric/dyadic.hpp"

#if !defined(__SIZEOF_INT128__)
#error "graze: the exact stage needs 128-bit integers (g++ or clang on a 64-bit target)."
#endif

namespace graze::numeric {

__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

/// `limb[0]` is the least significant. Not initialised: these are large, and every operation writes all of its result.
template <int N>
struct Integer {
  std::uint64_t limb[N];

  [[nodiscard]] bool is_negative() const noexcept { return (limb[N - 1] >> 63) != 0; }
  [[nodiscard]] bool is_zero() const noexcept {
    std::uint64_t any = 0;
    for (int i = 0; i < N; ++i) any |= limb[i];
    return any == 0;
  }
  [[nodiscard]] int sign() const noexcept { return is_negative() ? -1 : is_zero() ? 0 : 1; }
};

template <int N>
[[nodiscard]] inline Integer<N> operator+(const Integer<N>& a, const Integer<N>& b) noexcept {
  Integer<N> r;
  unsigned char carry = 0;
  for (int i = 0; i < N; ++i) {
    const Wide s = Wide(a.limb[i]) + b.limb[i] + carry;
    r.limb[i] = static_cast<std::uint64_t>(s);
    carry = static_cast<unsigned char>(s >> 64);
  }
  return r;
}

template <int N>
[[nodiscard]] inline Integer<N> operator-(const Integer<N>& a, const Integer<N>& b) noexcept {
  Integer<N> r;
  unsigned char borrow = 0;
  for (int i = 0; i < N; ++i) {
    const Wide s = Wide(a.limb[i]) - b.limb[i] - borrow;
    r.limb[i] = static_cast<std::uint64_t>(s);
    borrow = static_cast<unsigned char>((s >> 64) & 1);
  }
  return r;
}

/// a where `negate` is false, -a where it is true.
template <int N>
[[nodiscard]] inline Integer<N> negate_if(bool negate, const Integer<N>& a) noexcept {
  const std::uint64_t mask = negate ? ~std::uint64_t(0) : 0;
  Integer<N> r;
  unsigned char carry = negate ? 1 : 0;
  for (int i = 0; i < N; ++i) {
    const Wide s = Wide(a.limb[i] ^ mask) + carry;
    r.limb[i] = static_cast<std::uint64_t>(s);
    carry = static_cast<unsigned char>(s >> 64);
  }
  return r;
}

template <int N>
[[nodiscard]] inline Integer<N> operator-(const Integer<N>& a) noexcept {
  return negate_if(true, a);
}

template <int N>
[[nodiscard]] inline Integer<N> abs(const Integer<N>& a) noexcept {
  return negate_if(a.is_negative(), a);
}

/// The same value in W >= N limbs.
template <int W, int N>
[[nodiscard]] inline Integer<W> extend(const Integer<N>& a) noexcept {
  static_assert(W >= N);
  Integer<W> r;
  const std::uint64_t fill = a.is_negative() ? ~std::uint64_t(0) : 0;
  for (int i = 0; i < W; ++i) r.limb[i] = i < N ? a.limb[i] : fill;
  return r;
}

/// The exact product; it always fits.
template <int N, int M>
[[nodiscard]] inline Integer<N + M> operator*(const Integer<N>& a, const Integer<M>& b) noexcept {
  if constexpr (N == 1 && M == 1) {
    const SignedWide p = SignedWide(static_cast<std::int64_t>(a.limb[0])) * static_cast<std::int64_t>(b.limb[0]);
    return {{static_cast<std::uint64_t>(p), static_cast<std::uint64_t>(static_cast<Wide>(p) >> 64)}};
  } else {
    const Integer<N> x = abs(a);
    const Integer<M> y = abs(b);
    Integer<N + M> r;
    for (int i = 0; i < N + M; ++i) r.limb[i] = 0;
    for (int i = 0; i < N; ++i) {
      // Inputs of a wide span are short mantissas between many zero limbs.
      if (N > 3 && x.limb[i] == 0) continue;
      std::uint64_t carry = 0;
      for (int j = 0; j < M; ++j) {
        const Wide s = Wide(x.limb[i]) * y.limb[j] + r.limb[i + j] + carry;
        r.limb[i + j] = static_cast<std::uint64_t>(s);
        carry = static_cast<std::uint64_t>(s >> 64);
      }
      r.limb[i + M] = carry;
    }
    return negate_if(a.is_negative() != b.is_negative(), r);
  }
}

/// a * 2^shift modulo 2^(64 N), shift >= 0.
template <int N>
[[nodiscard]] inline Integer<N> shift_left(const Integer<N>& a, int shift) noexcept {
  const int limbs = shift / 64, bits = shift % 64;
  Integer<N> r;
  for (int i = N - 1; i >= 0; --i) {
    const std::uint64_t high = i - limbs >= 0 ? a.limb[i - limbs] : 0;
    const std::uint64_t low = i - limbs - 1 >= 0 ? a.limb[i - limbs - 1] : 0;
    r.limb[i] = bits == 0 ? high : (high << bits) | (low >> (64 - bits));
  }
  return r;
}

/// The sign of a - b.
template <int N>
[[nodiscard]] inline int compare(const Integer<N>& a, const Integer<N>& b) noexcept {
  if (a.is_negative() != b.is_negative()) return a.is_negative() ? -1 : 1;
  for (int i = N - 1; i >= 0; --i) {
    if (a.limb[i] != b.limb[i]) return a.limb[i] < b.limb[i] ? -1 : 1;
  }
  return 0;
}

/// The integer d / 2^unit; d is a multiple of 2^unit and the quotient fits.
template <int N>
[[nodiscard]] inline Integer<N> integer(const Dyadic& d, int unit) noexcept {
  Integer<N> r;
  for (int i = 0; i < N; ++i) r.limb[i] = 0;
  if (d.mantissa == 0) return r;
  const int shift = d.exponent - unit;
  const int limbs = shift / 64, bits = shift % 64;
  if constexpr (N == 1) {
    r.limb[0] = d.mantissa << bits;
  } else {
    r.limb[limbs] = d.mantissa << bits;
    if (bits != 0 && limbs + 1 < N) r.limb[limbs + 1] = d.mantissa >> (64 - bits);
  }
  return negate_if(d.negative, r);
}

}  // namespace graze::numeric
