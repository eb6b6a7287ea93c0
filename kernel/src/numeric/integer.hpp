// Integers of fixed width on the stack, two's complement, wrapping modulo 2^(64 N). Sums and products may wrap on the way: a
// result is right whenever its true value fits its width, and each use says why it does.
#pragma once

#include <bit>
#include <cstdint>

#include "numeric/dyadic.hpp"
#if !defined(__SIZEOF_INT128__)
#include "numeric/portable_wide.hpp"
#endif

namespace graze::numeric {

#if defined(__SIZEOF_INT128__)
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;
#else
using Wide = PortableWide;
using SignedWide = PortableSignedWide;
#endif

/// a + b + carry to `sum`; returns the carry out.
[[nodiscard]] inline unsigned char add(std::uint64_t a, std::uint64_t b, unsigned char carry, std::uint64_t& sum) noexcept {
#if defined(__x86_64__)
  unsigned long long out;  // NOLINT(google-runtime-int): the builtin's type
  const unsigned char next = __builtin_ia32_addcarryx_u64(carry, a, b, &out);
  sum = out;
  return next;
#else
  const Wide s = Wide(a) + b + carry;
  sum = static_cast<std::uint64_t>(s);
  return static_cast<unsigned char>(s >> 64);
#endif
}

/// a - b - borrow to `difference`; returns the borrow out.
[[nodiscard]] inline unsigned char subtract(std::uint64_t a, std::uint64_t b, unsigned char borrow,
                                            std::uint64_t& difference) noexcept {
#if defined(__x86_64__)
  unsigned long long out;  // NOLINT(google-runtime-int): the builtin's type
#if defined(__clang__)
  const unsigned char next = __builtin_ia32_subborrow_u64(borrow, a, b, &out);
#else
  const unsigned char next = __builtin_ia32_sbb_u64(borrow, a, b, &out);
#endif
  difference = out;
  return next;
#else
  const Wide s = Wide(a) - b - borrow;
  difference = static_cast<std::uint64_t>(s);
  return static_cast<unsigned char>((s >> 64) & 1);
#endif
}

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
  for (int i = 0; i < N; ++i) carry = add(a.limb[i], b.limb[i], carry, r.limb[i]);
  return r;
}

template <int N>
[[nodiscard]] inline Integer<N> operator-(const Integer<N>& a, const Integer<N>& b) noexcept {
  Integer<N> r;
  unsigned char borrow = 0;
  for (int i = 0; i < N; ++i) borrow = subtract(a.limb[i], b.limb[i], borrow, r.limb[i]);
  return r;
}

/// Subtracts b from the N limbs at `limb`, without the borrow out of them.
template <int N>
inline void subtract_from(std::uint64_t* limb, const Integer<N>& b) noexcept {
  unsigned char borrow = 0;
  for (int i = 0; i < N; ++i) borrow = subtract(limb[i], b.limb[i], borrow, limb[i]);
}

/// a where `negate` is false, -a where it is true.
template <int N>
[[nodiscard]] inline Integer<N> negate_if(bool negate, const Integer<N>& a) noexcept {
  const std::uint64_t mask = negate ? ~std::uint64_t(0) : 0;
  Integer<N> r;
  // (a xor mask) - mask, with the mask as an integer of all ones or none.
  unsigned char borrow = 0;
  for (int i = 0; i < N; ++i) borrow = subtract(a.limb[i] ^ mask, mask, borrow, r.limb[i]);
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

/// The product of the limbs as unsigned integers.
template <int N, int M>
[[nodiscard]] inline Integer<N + M> unsigned_product(const Integer<N>& a, const Integer<M>& b) noexcept {
  Integer<N + M> r;
  for (int i = 0; i < N + M; ++i) r.limb[i] = 0;
  for (int i = 0; i < N; ++i) {
    // Inputs of a wide span are short mantissas between many zero limbs.
    if (N > 3 && a.limb[i] == 0) continue;
    std::uint64_t carry = 0;
    for (int j = 0; j < M; ++j) {
      const Wide s = Wide(a.limb[i]) * b.limb[j] + r.limb[i + j] + carry;
      r.limb[i + j] = static_cast<std::uint64_t>(s);
      carry = static_cast<std::uint64_t>(s >> 64);
    }
    r.limb[i + M] = carry;
  }
  return r;
}

/// The exact product; it always fits.
template <int N, int M>
[[nodiscard]] inline Integer<N + M> operator*(const Integer<N>& a, const Integer<M>& b) noexcept {
  if constexpr (N == 1 && M == 1) {
    const SignedWide p = SignedWide(static_cast<std::int64_t>(a.limb[0])) * static_cast<std::int64_t>(b.limb[0]);
    return {{static_cast<std::uint64_t>(p), static_cast<std::uint64_t>(static_cast<Wide>(p) >> 64)}};
  } else if constexpr (N + M <= 6) {
    // A negative a reads 2^(64 N) too large, which adds b 2^(64 N) to the product; likewise b.
    Integer<N + M> r = unsigned_product(a, b);
    const std::uint64_t a_mask = a.is_negative() ? ~std::uint64_t(0) : 0, b_mask = b.is_negative() ? ~std::uint64_t(0) : 0;
    Integer<M> high_b;
    for (int i = 0; i < M; ++i) high_b.limb[i] = b.limb[i] & a_mask;
    Integer<N> high_a;
    for (int i = 0; i < N; ++i) high_a.limb[i] = a.limb[i] & b_mask;
    subtract_from(r.limb + N, high_b);
    subtract_from(r.limb + M, high_a);
    return r;
  } else {
    return negate_if(a.is_negative() != b.is_negative(), unsigned_product(abs(a), abs(b)));
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
  if constexpr (N == 1) {
    // The shift is below 64, or nothing is shifted.
    r.limb[0] = d.mantissa << ((d.exponent - unit) & 63);
  } else {
    for (int i = 0; i < N; ++i) r.limb[i] = 0;
    if (d.mantissa == 0) return r;
    const int shift = d.exponent - unit;
    const int limbs = shift / 64, bits = shift % 64;
    r.limb[limbs] = d.mantissa << bits;
    if (bits != 0 && limbs + 1 < N) r.limb[limbs + 1] = d.mantissa >> (64 - bits);
  }
  return negate_if(d.negative, r);
}

}  // namespace graze::numeric
