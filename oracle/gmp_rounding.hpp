// Quotients and quadratic roots of integers, cut short without losing anything, and then rounded once.
#pragma once

#include <gmpxx.h>

#include "graze/types.hpp"

namespace graze::oracle::gmp {

/// sign * (head + fraction) * 2^exponent with 0 <= fraction < 1, where fraction = 0 exactly if `exact`. sign = 0 is zero.
struct Truncated {
  int sign = 0;
  mpz_class head;
  long exponent = 0;
  bool exact = true;
};

/// numerator / denominator * 2^exponent, with a head of at least `digits` bits unless it is exact. denominator > 0.
void truncate_quotient(Truncated& out, const mpz_class& numerator, const mpz_class& denominator, long exponent, int digits);

/// (b + root_sign * sqrt(d)) / a * 2^exponent, with a head of at least `digits` bits unless it is exact. a > 0, d >= 0.
void truncate_root(Truncated& out, const mpz_class& b, int root_sign, const mpz_class& d, const mpz_class& a, long exponent,
                   int digits);

/// The sign of b + root_sign * sqrt(d); d >= 0.
[[nodiscard]] int sign_of_root(const mpz_class& b, int root_sign, const mpz_class& d);

/// floor(log2 |x|) of a number that is not zero.
[[nodiscard]] long floor_log2(const Truncated& x);

/// How many bits of a head `nearest` needs.
template <Real T>
inline constexpr int kRoundingDigits = std::numeric_limits<T>::digits + 2;

/// The nearest number of the format, ties to even, overflow to infinity, zero always positive.
template <Real T>
[[nodiscard]] T nearest(const Truncated& x);

}  // namespace graze::oracle::gmp
