// The correctly rounded quotient, by the oracle's rounding.
#pragma once

#include "oracle/gmp_rounding.hpp"

namespace graze::test {

/// The number of the format nearest to numerator / denominator * 2^exponent, ties to even.
template <Real T>
[[nodiscard]] T nearest(const mpz_class& numerator, const mpz_class& denominator, int exponent = 0) {
  oracle::gmp::Truncated cut;
  const int sign = sgn(denominator);
  oracle::gmp::truncate_quotient(cut, sign * numerator, sign * denominator, exponent, oracle::gmp::kRoundingDigits<T>);
  return oracle::gmp::nearest<T>(cut);
}

}  // namespace graze::test
