// Fractions of integers that are never reduced: num / den with den > 0. A parameter of a ray is such a fraction times the
// power of two that the query's units leave over.
#pragma once

#include <gmpxx.h>

#include "oracle/gmp_dyadic.hpp"
#include "oracle/gmp_rounding.hpp"
#include "oracle/oracle.hpp"

namespace graze::oracle::gmp {

struct Fraction {
  mpz_class num = 0;
  mpz_class den = 1;
};

/// Brings the sign of the denominator, which is not zero, into the numerator.
inline void make_denominator_positive(Fraction& x) {
  if (sgn(x.den) > 0) return;
  mpz_neg(x.num.get_mpz_t(), x.num.get_mpz_t());
  mpz_neg(x.den.get_mpz_t(), x.den.get_mpz_t());
}

/// The sign of x - y.
[[nodiscard]] inline int compare(const Fraction& x, const Fraction& y) {
  thread_local mpz_class left, right;
  mpz_mul(left.get_mpz_t(), x.num.get_mpz_t(), y.den.get_mpz_t());
  mpz_mul(right.get_mpz_t(), y.num.get_mpz_t(), x.den.get_mpz_t());
  return cmp(left, right);
}

/// out * 2^exponent = x.
inline void set_fraction(Fraction& out, const Dyadic& x, int exponent) {
  out.num = static_cast<long>(x.mantissa);
  out.den = 1;
  if (x.mantissa == 0) return;
  const long shift = static_cast<long>(x.exponent) - exponent;
  mpz_class& scaled = shift >= 0 ? out.num : out.den;
  mpz_mul_2exp(scaled.get_mpz_t(), scaled.get_mpz_t(), static_cast<mp_bitcnt_t>(std::abs(shift)));
}

/// The sign of x * 2^exponent - bound.
[[nodiscard]] inline int compare(const Fraction& x, int exponent, const Dyadic& bound) {
  if (bound.mantissa == 0) return sgn(x.num);
  thread_local Fraction scaled;
  set_fraction(scaled, bound, exponent);
  return compare(x, scaled);
}

/// The number of the format nearest to x * 2^exponent.
template <Real T>
[[nodiscard]] T nearest(const Fraction& x, int exponent) {
  thread_local Truncated truncated;
  truncate_quotient(truncated, x.num, x.den, exponent, kRoundingDigits<T>);
  return nearest<T>(truncated);
}

/// x * 2^exponent as a reduced rational.
[[nodiscard]] inline mpq_class rational(const Fraction& x, int exponent) {
  mpq_class result(x.num, x.den);
  result.canonicalize();
  if (exponent >= 0) {
    mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return result;
}

}  // namespace graze::oracle::gmp
