// The measure of error, against values computed by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

[[nodiscard]] Exact rational(const mpq_class& q) {
  return {q, 0, 0};
}
[[nodiscard]] mpq_class two_to(int exponent) {
  mpq_class result = 1;
  if (exponent >= 0) {
    result <<= static_cast<mp_bitcnt_t>(exponent);
  } else {
    result >>= static_cast<mp_bitcnt_t>(-exponent);
  }
  return result;
}

template <class Test>
void both_formats(Test test) {
  {
    INFO("float");
    test.template operator()<float>();
  }
  {
    INFO("double");
    test.template operator()<double>();
  }
}

TEST_CASE("The error of a rational") {
  both_formats([]<Real T>() {
    const T ulp = std::numeric_limits<T>::epsilon();
    CHECK(error_in_ulps<T>(rational(1), 1) == 0);
    CHECK(error_in_ulps<T>(rational(1), 1 + ulp) == 1);
    CHECK(error_in_ulps<T>(rational(1), 1 - ulp / 2) == 0.5);
    CHECK(error_in_ulps<T>(rational(1), -1) == 2 / double(ulp));
    CHECK(error_in_ulps<T>(rational(-1), -1 - 3 * ulp) == 3);
    // In both formats 1/3 is a third of a unit from its nearest number.
    CHECK(error_in_ulps<T>(rational(mpq_class(1, 3)), T(1) / T(3)) == 1.0 / 3);
    CHECK(error_in_ulps<T>(rational(mpq_class(-1, 3)), T(-1) / T(3)) == 1.0 / 3);
    // The unit is that of the value, also where the number lies in the next binade.
    CHECK(error_in_ulps<T>(rational(mpq_class(4, 3)), 2) == 2.0 / 3 / double(ulp));
    CHECK(error_in_ulps<T>(rational(2), T(4) / T(3)) == double((2 - T(4) / T(3)) / (2 * ulp)));
    CHECK(error_in_ulps<T>(rational(mpq_class(1) + two_to(-3000)), 1) == 0);
  });
}

TEST_CASE("Near zero the unit is the least number") {
  both_formats([]<Real T>() {
    const T least = kLeast<T>;
    const int exponent = std::same_as<T, double> ? -1074 : -149;
    CHECK(error_in_ulps<T>(rational(0), 0) == 0);
    CHECK(error_in_ulps<T>(rational(0), T(-0.0)) == 0);
    CHECK(error_in_ulps<T>(rational(0), least) == 1);
    CHECK(error_in_ulps<T>(rational(0), -least) == 1);
    CHECK(error_in_ulps<T>(rational(two_to(exponent) * 3 / 2), least) == 0.5);
    CHECK(error_in_ulps<T>(rational(two_to(exponent - 10)), 0) == 0x1p-10);
    CHECK(error_in_ulps<T>(rational(two_to(exponent) * 5), 7 * least) == 2);
  });
}

TEST_CASE("Where numbers end the unit is the largest") {
  both_formats([]<Real T>() {
    const int overflow = std::numeric_limits<T>::max_exponent;
    const double digits = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const T big = kGreatest<T>;
    const Exact too_large = rational(two_to(overflow));
    CHECK(error_in_ulps<T>(too_large, kInfinity<T>) == 0);
    CHECK(error_in_ulps<T>(too_large, -kInfinity<T>) == kInfinity<double>);
    CHECK(error_in_ulps<T>(too_large, big) == 1);
    CHECK(error_in_ulps<T>(too_large, 0) == digits);
    CHECK(error_in_ulps<T>(rational(-two_to(overflow)), -kInfinity<T>) == 0);
    CHECK(error_in_ulps<T>(rational(two_to(overflow + 1)), 0) == 2 * digits);
    // The tie above the greatest number rounds to infinity, what lies below it does not.
    const mpq_class tie = two_to(overflow) - two_to(overflow - std::numeric_limits<T>::digits - 1);
    CHECK(error_in_ulps<T>(rational(tie), kInfinity<T>) == 0);
    CHECK(error_in_ulps<T>(rational(tie), big) == 0.5);
    CHECK(error_in_ulps<T>(rational(tie - two_to(-2000)), kInfinity<T>) == kInfinity<double>);
  });
}

TEST_CASE("NaN is infinitely wrong, and so is an infinity where a number is right") {
  both_formats([]<Real T>() {
    CHECK(error_in_ulps<T>(rational(1), std::numeric_limits<T>::quiet_NaN()) == kInfinity<double>);
    CHECK(error_in_ulps<T>(rational(two_to(5000)), std::numeric_limits<T>::quiet_NaN()) == kInfinity<double>);
    CHECK(error_in_ulps<T>(rational(1), kInfinity<T>) == kInfinity<double>);
    CHECK(error_in_ulps<T>(rational(1), -kInfinity<T>) == kInfinity<double>);
  });
}

TEST_CASE("The error of a root") {
  both_formats([]<Real T>() {
    const bool is_double = std::same_as<T, double>;
    const T root = T(is_double ? 0x1.6a09e667f3bcdp+0 : 0x1.6a09e6p+0);
    const double error = is_double ? 0x1.bdd3413b26456p-2 : 0x1.9fcef32422cbfp-3;  // of sqrt(2), to 60 decimals
    CHECK(error_in_ulps<T>(Exact{0, 2, 1}, root) == error);
    CHECK(error_in_ulps<T>(Exact{0, 2, -1}, -root) == error);
    CHECK(error_in_ulps<T>(Exact{0, mpq_class(1, 2), 1}, root / 2) == error);
    CHECK(error_in_ulps<T>(Exact{0, mpq_class(9, 4), 1}, T(1.5)) == 0);
    CHECK(error_in_ulps<T>(Exact{mpq_class(1, 2), mpq_class(9, 4), -1}, -1) == 0);
    CHECK(error_in_ulps<T>(Exact{1, 1, -1}, 0) == 0);
    CHECK(error_in_ulps<T>(Exact{5, 0, -1}, 5) == 0);
    // 1 - sqrt(1 - 2^-100) = 2^-101 + 2^-203 + ...: everything cancels, and the second term is the error of the first.
    const Exact small{1, mpq_class(1) - two_to(-100), -1};
    CHECK(error_in_ulps<T>(small, T(0x1p-101)) == std::ldexp(1.0, -203 + 101 + std::numeric_limits<T>::digits - 1));
  });
}

TEST_CASE("The right answer to a query is off by half a unit at most") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const SphereTruth<T> sphere = oracle.truth(Ray<T>{{0, 0, 0}, {3, 2, 1}}, Sphere<T>{{7, 5, 2}, 3});
    REQUIRE(sphere.hit.count() == 2);
    for (int i : {0, 1}) {
      CHECK(error_in_ulps(sphere.t[i], sphere.hit.t[i]) < 0.5);
      CHECK(error_in_ulps(sphere.t[i], std::nextafter(sphere.hit.t[i], T(0))) > 0.5);
      CHECK(error_in_ulps(sphere.t[i], std::nextafter(sphere.hit.t[i], T(9))) > 0.5);
    }
  });
}

}  // namespace
}  // namespace graze::oracle
