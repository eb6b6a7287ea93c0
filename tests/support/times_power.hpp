// Rationals times powers of two.
#pragma once

#include <gmpxx.h>

#include <utility>

namespace graze::test {

/// value * 2^exponent.
[[nodiscard]] inline mpq_class times_power(mpq_class value, int exponent) {
  if (exponent >= 0) {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return value;
}

}  // namespace graze::test
