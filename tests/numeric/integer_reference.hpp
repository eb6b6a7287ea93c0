// Integers of fixed width beside GMP's, and the widths and values at which carries and signs go wrong.
#pragma once

#include <gmpxx.h>

#include "fuzz/random.hpp"
#include "numeric/integer.hpp"

namespace graze::test {

using numeric::Integer;

/// The value that two's complement gives the limbs.
template <int N>
[[nodiscard]] mpz_class value_of(const Integer<N>& a) {
  mpz_class value;
  mpz_import(value.get_mpz_t(), N, -1, sizeof(std::uint64_t), 0, 0, a.limb);
  if ((a.limb[N - 1] >> 63) != 0) value -= mpz_class(1) << (64 * N);
  return value;
}

static_assert(sizeof(unsigned long) == sizeof(std::uint64_t), "GMP takes a limb as an unsigned long");

[[nodiscard]] inline mpz_class integer_of(std::uint64_t x) {
  return static_cast<unsigned long>(x);
}

/// The integer congruent to the value modulo 2^(64 N).
template <int N>
[[nodiscard]] Integer<N> wrapped(const mpz_class& value) {
  mpz_class rest;
  mpz_fdiv_r_2exp(rest.get_mpz_t(), value.get_mpz_t(), 64 * N);
  Integer<N> a{};
  mpz_export(a.limb, nullptr, -1, sizeof(std::uint64_t), 0, 0, rest.get_mpz_t());
  return a;
}

template <int N>
[[nodiscard]] bool same(const Integer<N>& a, const Integer<N>& b) {
  for (int i = 0; i < N; ++i) {
    if (a.limb[i] != b.limb[i]) return false;
  }
  return true;
}

/// 0, 1, -1, the least and the greatest value, small ones, one bit, runs of ones and zeros, sparse limbs, random limbs.
template <int N>
[[nodiscard]] Integer<N> random_integer(fuzz::Random& random) {
  constexpr std::uint64_t top = std::uint64_t(1) << 63;
  Integer<N> a{};
  const auto sort = random.below(10);
  for (int i = 0; i < N; ++i) {
    const std::uint64_t bits = random.bits();
    if (sort == 1) a.limb[i] = ~std::uint64_t(0);
    if (sort == 3) a.limb[i] = i == N - 1 ? ~top : ~std::uint64_t(0);
    if (sort == 6) a.limb[i] = (bits & 1) != 0 ? ~std::uint64_t(0) : 0;
    if (sort == 7) a.limb[i] = (bits & 3) == 0 ? random.bits() : 0;
    if (sort >= 8) a.limb[i] = bits;
  }
  if (sort == 2) a.limb[N - 1] = top;
  if (sort == 4) a.limb[0] = random.below(4);
  if (sort == 5) a.limb[random.below(N)] = std::uint64_t(1) << random.below(64);
  return random.one_in(4) ? numeric::negate_if(true, a) : a;
}

/// Calls test.operator()<N>() for the widths that the kernel uses, and their neighbours.
template <class Test>
void for_each_width(Test test) {
  test.template operator()<1>();
  test.template operator()<2>();
  test.template operator()<3>();
  test.template operator()<4>();
  test.template operator()<5>();
  test.template operator()<6>();
  test.template operator()<12>();
  test.template operator()<33>();
  test.template operator()<66>();
  test.template operator()<132>();
}

/// Fewer rounds for wider integers.
template <int N>
inline constexpr std::uint64_t rounds = N <= 6 ? 20000 : 100000 / N;

inline constexpr std::uint64_t integer_seed = 64;

}  // namespace graze::test
