// A number and the integer times a power of two that it is read as.
#include "numeric/dyadic.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"
#include "tests/support/bit_patterns.hpp"

namespace graze::test {
namespace {

using numeric::Dyadic;
using numeric::dyadic;
using numeric::Extent;

/// x * 2^1074 by GMP's own reading of a double.
mpz_class in_least_units(double x) {
  mpq_class scaled(x);
  mpq_mul_2exp(scaled.get_mpq_t(), scaled.get_mpq_t(), 1074);
  return scaled.get_num();
}

bool stands_for(const Dyadic& d, double x) {
  if (x == 0) return d.is_zero() && d.sign() == 0 && d.negative == std::signbit(x);
  if ((d.mantissa & 1) == 0 || d.negative != (x < 0) || d.sign() != (x < 0 ? -1 : 1) || d.exponent < -1074) return false;
  mpz_class value = integer_of(d.mantissa);
  const int leading = d.exponent + static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
  value <<= static_cast<mp_bitcnt_t>(d.exponent + 1074);
  if (d.negative) value = -value;
  return value == in_least_units(x) && d.top() == leading && leading == std::ilogb(x) + 1;
}

TEST_CASE("Every finite bit pattern is read as the number that it is") {
  int wrong = 0, read = 0;
  each_pattern([&](auto x) {
    if (!std::isfinite(x)) return;
    ++read;
    if (!stands_for(dyadic(x), x)) ++wrong;
  });
  CHECK(wrong == 0);
  CHECK(read > 300000);
}

TEST_CASE("Reading is done at compile time too") {
  static_assert(dyadic(6.0).mantissa == 3 && dyadic(6.0).exponent == 1 && !dyadic(6.0).negative);
  static_assert(dyadic(-0x1p-149f).mantissa == 1 && dyadic(-0x1p-149f).exponent == -149 && dyadic(-0x1p-149f).negative);
  static_assert(dyadic(0.0f).is_zero());
  CHECK(dyadic(0x1.fffffffffffffp1023).top() == 1024);
}

TEST_CASE("An extent spans the bits of what it includes, zeros apart") {
  Extent extent;
  CHECK(extent.width() <= 0);
  extent.include(dyadic(0.0));
  extent.include(dyadic(Vec3<double>{0, -0.0, 0}));
  CHECK(extent.width() <= 0);
  extent.include(dyadic(Vec3<double>{0, 6, 0}));
  CHECK(extent.low == 1);
  CHECK(extent.high == 3);
  extent.include(dyadic(-0.125f));
  CHECK(extent.low == -3);
  CHECK(extent.width() == 6);
  extent.include(dyadic(Vec3<double>{0x1p-1074, 0, 0x1.fffffffffffffp1023}));
  CHECK(extent.width() == 2098);
}

}  // namespace
}  // namespace graze::test
