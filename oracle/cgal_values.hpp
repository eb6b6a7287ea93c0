// The two sorts of exact values that an answer may have, and their order among the representable numbers.
#pragma once

#include <cmath>

#include "oracle/cgal_kernel.hpp"
#include "oracle/oracle.hpp"

namespace graze::oracle::cgal {

/// A root of a quadratic: (rational part +- sqrt(discriminant)) / denominator. Its comparisons are made without CGAL's interval
/// filter (the last tag), which no exponent can then lead astray.
struct QuadraticRoot {
  using Numerator = CGAL::Sqrt_extension<Number, Number, CGAL::Tag_false, CGAL::Tag_false>;
  Numerator numerator;
  Number denominator;  ///< > 0
};

[[nodiscard]] inline CGAL::Comparison_result compare(const Field& value, const Number& x) {
  return CGAL::compare(value, Field(x));
}

[[nodiscard]] inline CGAL::Comparison_result compare(const QuadraticRoot& value, const Number& x) {
  return value.numerator.compare(x * value.denominator);
}

[[nodiscard]] inline Field negate(const Field& value) {
  return -value;
}
[[nodiscard]] inline QuadraticRoot negate(const QuadraticRoot& value) {
  return {-value.numerator, value.denominator};
}

/// A guess where the value is; neither bounds nor even finiteness are promised.
[[nodiscard]] inline double guess(const Field& value) {
  return CGAL::to_double(value);
}
[[nodiscard]] inline double guess(const QuadraticRoot& value) {
  const Field rational(value.numerator.a0(), value.denominator);
  const Field radicand(value.numerator.root(), value.denominator * value.denominator);
  return CGAL::to_double(rational) + CGAL::to_double(value.numerator.a1()) * std::sqrt(CGAL::to_double(radicand));
}

/// The same number for the reports, which speak GMP: the only place where the CGAL oracle does.
[[nodiscard]] inline mpq_class to_gmp(const Number& x) {
  constexpr long kLimbBits = 8 * sizeof(Number::limb);
  mpz_class mantissa = 0;
  for (auto limb = x.v.rbegin(); limb != x.v.rend(); ++limb) mantissa = (mantissa << kLimbBits) + *limb;
  const long exponent = static_cast<long>(x.min_exp()) * kLimbBits;
  mpq_class result = mantissa;
  if (exponent >= 0) {
    result <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    result >>= static_cast<mp_bitcnt_t>(-exponent);
  }
  return result;
}

[[nodiscard]] inline Exact to_exact(const Field& value) {
  return {to_gmp(value.numerator()) / to_gmp(value.denominator()), 0, 0};
}

[[nodiscard]] inline Exact to_exact(const QuadraticRoot& value) {
  const mpq_class denominator = to_gmp(value.denominator);
  return {to_gmp(value.numerator.a0()) / denominator, to_gmp(value.numerator.root()) / (denominator * denominator),
          static_cast<int>(CGAL::sign(value.numerator.a1()))};
}

}  // namespace graze::oracle::cgal
