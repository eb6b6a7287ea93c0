// Exact quotients rounded and compared, against GMP: ties and near-ties, subnormal results, overflow, both formats.
#include <limits>

#include "exact/interval.hpp"
#include "exact/quotient.hpp"
#include "exact/range.hpp"
#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"
#include "tests/numeric/nearest.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using exact::Quotient;
using numeric::Dyadic;

constexpr std::uint64_t seed = 9;

/// numerator / denominator * 2^scale.
struct Fraction {
  mpz_class numerator, denominator;
  int scale;
};

template <int N, Real T>
std::uint64_t rounded(const Quotient<N>& value) {
  return round_to_bits(value, numeric::format_of<T>);
}

/// The sign of the fraction minus x.
int order_against(const Fraction& f, double x) {
  mpq_class value(f.numerator, f.denominator);
  value.canonicalize();
  mpz_class& side = f.scale >= 0 ? value.get_num() : value.get_den();
  side <<= static_cast<mp_bitcnt_t>(std::abs(f.scale));
  value.canonicalize();
  const int order = cmp(value, mpq_class(x));
  return (order > 0) - (order < 0);
}

template <int N, Real T>
void check(const Fraction& f, fuzz::Random& random) {
  const Quotient<N> value(wrapped<N>(f.numerator), wrapped<N>(f.denominator), f.scale);
  const T expected = nearest<T>(f.numerator, f.denominator, f.scale);
  const Environment& environment = environments[random.below(environments.size())];
  bool is_right = in_mode(environment, rounded<N, T>, value) == numeric::bits_of(expected);
  // Comparisons with the number nearest to it, its neighbours and any number.
  const T finite = std::isfinite(expected) ? expected : std::numeric_limits<T>::max();
  for (const T x : {finite, std::nextafter(finite, T(0)), std::nextafter(finite, 2 * finite), random_finite<T>(random), T(0)}) {
    if (!std::isfinite(x)) continue;
    is_right = is_right && numeric::compare(value, numeric::dyadic(x)) == order_against(f, static_cast<double>(x));
  }
  if (is_right) return;
  CAPTURE(N, sizeof(T), environment, f.scale, expected);
  INFO(f.numerator.get_str(16) << " / " << f.denominator.get_str(16));
  REQUIRE(is_right);
}

template <int N>
mpz_class random_below(fuzz::Random& random, int bits) {
  const mpz_class value = abs(value_of(random_integer<N>(random)));
  const auto width = static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
  return width > bits ? mpz_class(value >> (width - bits)) : value;
}

/// A scale that brings a quotient of that size to 2^exponent.
int scale_to(int exponent, const mpz_class& numerator, const mpz_class& denominator) {
  return exponent - static_cast<int>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) +
         static_cast<int>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
}

template <Real T>
int random_exponent(fuzz::Random& random) {
  using Limits = std::numeric_limits<T>;
  constexpr int least = Limits::min_exponent - Limits::digits;
  switch (random.below(4)) {
    case 0:
      return random.between(least - 4, Limits::min_exponent + 2);  // subnormal, or zero
    case 1:
      return random.between(Limits::max_exponent - 3, Limits::max_exponent + 3);
    case 2:
      return random.between(-3, 3);
    default:
      return random.between(least - 200, Limits::max_exponent + 200);
  }
}

template <int N, Real T>
void check_random(int count) {
  fuzz::Random random(seed, "random quotients", N * 100 + sizeof(T));
  for (int round = 0; round < count; ++round) {
    mpz_class n = random_below<N>(random, 64 * N - 1), d = random_below<N>(random, 64 * N - 1);
    if (sgn(d) == 0) continue;
    const int scale = scale_to(random_exponent<T>(random), n, d);
    n *= random.sign();
    d *= random.sign();
    check<N, T>({n, d, scale}, random);
  }
}

/// Quotients that are the middle between two numbers of the format, or off it by the least that N limbs allow.
template <int N, Real T>
void check_ties(int count) {
  fuzz::Random random(seed, "ties", N * 100 + sizeof(T));
  constexpr int digits = std::numeric_limits<T>::digits, least = std::numeric_limits<T>::min_exponent - digits;
  for (int round = 0; round < count; ++round) {
    // Fewer bits where the result is subnormal: the middle has one bit more than the numbers around it.
    const int width = random.one_in(3) ? random.between(1, digits) : digits;
    const int exponent = width < digits ? least - 1 : random.between(least - 1, std::numeric_limits<T>::max_exponent - digits);
    std::uint64_t middle = (random.bits() >> (63 - width)) | std::uint64_t(1) << width | 1;
    if (random.one_in(8)) middle = (std::uint64_t(2) << width) - 1;  // the next number up is a power of two, or infinity
    mpz_class d = random_below<N>(random, 64 * N - 2 - digits - 1) + 1;
    mpz_class n = integer_of(middle) * d;
    const int side = random.between(-1, 1);
    n += side;
    if (random.one_in(2)) n = -n;
    check<N, T>({n, d, exponent}, random);
  }
}

template <int N>
void check_width(int count) {
  CAPTURE(seed);
  check_random<N, float>(count);
  check_random<N, double>(count);
  check_ties<N, float>(count);
  check_ties<N, double>(count);
}

TEST_CASE("Quotients are rounded correctly and compared exactly") {
  check_width<2>(20000);
  check_width<3>(20000);
  check_width<4>(10000);
  check_width<6>(10000);
  check_width<15>(4000);
  check_width<36>(1000);
  check_width<66>(500);
  check_width<99>(300);
}

TEST_CASE("Quotients of one scale are compared with one another") {
  CAPTURE(seed);
  fuzz::Random random(seed, "pairs of quotients", 0);
  int equal = 0;
  for (int round = 0; round < 20000; ++round) {
    constexpr int N = 3;
    mpz_class n[2], d[2];
    for (int i : {0, 1}) {
      n[i] = random.sign() * random_below<N>(random, 160);
      d[i] = random.sign() * (random_below<N>(random, 160) + 1);
    }
    if (random.one_in(4)) {
      n[1] = n[0] * 6;
      d[1] = d[0] * 6;
    }
    const Quotient<N> first(wrapped<N>(n[0]), wrapped<N>(d[0]), 5), second(wrapped<N>(n[1]), wrapped<N>(d[1]), 5);
    const mpz_class difference = (n[0] * d[1] - n[1] * d[0]) * sgn(d[0]) * sgn(d[1]);
    equal += sgn(difference) == 0;
    if (first.compare_with(second) == sgn(difference) && first.sign() == sgn(n[0]) * sgn(d[0])) continue;
    INFO(n[0] << " / " << d[0] << " and " << n[1] << " / " << d[1]);
    REQUIRE(false);
  }
  CHECK(equal > 1000);
}

TEST_CASE("Zero is zero, whatever the denominator and the scale") {
  for (const int d : {-3, 1}) {
    for (const int scale : {-5000, 0, 1 << 20}) {
      const Quotient<2> zero(wrapped<2>(0), wrapped<2>(d), scale);
      CHECK(zero.sign() == 0);
      CHECK(rounded<2, double>(zero) == 0);
      CHECK(numeric::compare(zero, Dyadic{}) == 0);
      CHECK(numeric::compare(zero, numeric::dyadic(-0x1p-1074)) == 1);
    }
  }
}

TEST_CASE("A range has both its ends, and is compared before rounding") {
  in_both_formats([]<Real T>() {
    const T third = T(1) / T(3);  // above 1/3 in float, below it in double
    const Quotient<2> exact_third(wrapped<2>(1), wrapped<2>(3), 0), half(wrapped<2>(-2), wrapped<2>(-4), 0);
    const bool is_above = std::same_as<T, float>;
    CHECK(exact::range(third, std::numeric_limits<T>::infinity()).contains(exact_third) == !is_above);
    CHECK(exact::range(T(-1), third).contains(exact_third) == is_above);
    CHECK(exact::range(T(0.5), T(0.5)).contains(half));
    CHECK(exact::range(std::nextafter(T(0.5), T(1)), T(1)).starts_after(half));
    CHECK(exact::range(T(0), std::nextafter(T(0.5), T(0))).ends_before(half));
    CHECK(exact::range(T(0), T(0)).contains(Quotient<2>(wrapped<2>(0), wrapped<2>(7), 3)));
    CHECK(!exact::range(T(0), std::numeric_limits<T>::infinity()).ends_before(Quotient<2>(wrapped<2>(1), wrapped<2>(1), 5000)));
  });
}

TEST_CASE("A bound's bits are its own") {
  int wrong = 0;
  each_pattern([&]<Real T>(T x) {
    if (!std::isfinite(x)) return;
    wrong += exact::bound_bits(numeric::dyadic(x), numeric::format_of<T>) != (x == T(0) ? 0 : numeric::bits_of(x));
  });
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace graze::test
