// Error-free transforms are free of error, pairs of doubles within what is said of them; against GMP's rationals.
#include "numeric/double_double.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cstdio>

#include "tests/catch.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/in_mode.hpp"
#include "tests/support/times_power.hpp"

namespace graze::test {
namespace {

using numeric::Pair;

constexpr std::uint64_t seed = 106;

mpq_class value_of(const Pair& a) {
  return mpq_class(a.hi) + mpq_class(a.lo);
}

double random_double(fuzz::Random& random, int spread) {
  if (random.one_in(40)) return 0;
  return random_of_size<double>(random, random.between(-spread, spread));
}

/// A normalised pair: |lo| at most half a unit of hi, often as large as that, or zero.
Pair random_pair(fuzz::Random& random, int spread) {
  const double hi = random_of_size<double>(random, random.between(-spread, spread));
  const double lo = random.one_in(6) ? 0 : random_of_size<double>(random, std::ilogb(hi) - 53 - random.between(0, 3));
  return numeric::normalised(Pair{hi, lo});
}

/// The greatest share of its bound that an error took.
class Share {
 public:
  explicit Share(const char* name) : name_(name) {}
  ~Share() { std::printf("%s: at most %.3f of the bound\n", name_, greatest_); }
  Share(const Share&) = delete;
  Share& operator=(const Share&) = delete;

  /// Whether the error is within the bound.
  [[nodiscard]] bool admits(const mpq_class& error, const mpq_class& bound) {
    if (sgn(bound) != 0) greatest_ = std::max(greatest_, mpq_class(abs(error) / bound).get_d());
    return abs(error) <= bound;
  }
  [[nodiscard]] double greatest() const { return greatest_; }

 private:
  const char* name_;
  double greatest_ = 0;
};

TEST_CASE("Sums, differences and products are split without error") {
  CAPTURE(seed);
  fuzz::Random random(seed, "transforms", 0);
  for (int round = 0; round < 60000; ++round) {
    const double a = random_double(random, 60);
    double b = random_double(random, 60);
    if (random.one_in(8)) b = std::nextafter(-a, random.one_in(2) ? -1e30 : 1e30);
    const Pair sum = numeric::two_sum(a, b), difference = numeric::two_difference(a, b);
    const double wide_a = std::ldexp(a, random.between(-380, 380)), wide_b = std::ldexp(b, random.between(-380, 380));
    const Pair product = numeric::two_product(wide_a, wide_b);
    const bool is_right = value_of(sum) == mpq_class(a) + mpq_class(b) && sum.hi == a + b &&
                          value_of(difference) == mpq_class(a) - mpq_class(b) && difference.hi == a - b &&
                          value_of(product) == mpq_class(wide_a) * mpq_class(wide_b) && product.hi == wide_a * wide_b;
    if (is_right) continue;
    CAPTURE(hex(a), hex(b), hex(wide_a), hex(wide_b));
    REQUIRE(is_right);
  }
}

TEST_CASE("A sum of pairs errs by at most 4 / 2^106 of the magnitudes") {
  CAPTURE(seed);
  fuzz::Random random(seed, "sums", 0);
  Share share("pair sums");
  for (int round = 0; round < 40000; ++round) {
    const Pair a = random_pair(random, 20);
    Pair b = random_pair(random, 20);
    if (random.one_in(4)) b = {-a.hi, random_of_size<double>(random, std::ilogb(a.hi) - 54)};
    const mpq_class x = value_of(a), y = value_of(b), bound = times_power(4 * (abs(x) + abs(y)), -106);
    if (share.admits(value_of(a + b) - (x + y), bound) && share.admits(value_of(a - b) - (x - y), bound)) continue;
    CAPTURE(hex(a.hi), hex(a.lo), hex(b.hi), hex(b.lo));
    REQUIRE(false);
  }
  CHECK(share.greatest() > 0.1);
}

TEST_CASE("A product of pairs errs by at most 8 / 2^106 of itself, one with a number by 4 / 2^106") {
  CAPTURE(seed);
  fuzz::Random random(seed, "products", 0);
  Share with_number("number times pair"), share("pair products");
  for (int round = 0; round < 40000; ++round) {
    const Pair a = random_pair(random, 200), b = random_pair(random, 200);
    const mpq_class x = value_of(a), y = value_of(b);
    const bool is_right =
        with_number.admits(value_of(a.hi * b) - mpq_class(a.hi) * y, times_power(abs(4 * mpq_class(a.hi) * y), -106)) &&
        share.admits(value_of(a * b) - x * y, times_power(abs(8 * x * y), -106));
    if (is_right) continue;
    CAPTURE(hex(a.hi), hex(a.lo), hex(b.hi), hex(b.lo));
    REQUIRE(is_right);
  }
  CHECK(share.greatest() > 0.1);
  CHECK(with_number.greatest() > 0.1);
}

TEST_CASE("A pair is normalised without error") {
  CAPTURE(seed);
  fuzz::Random random(seed, "normalised", 0);
  for (int round = 0; round < 20000; ++round) {
    const double hi = random_of_size<double>(random, 0);
    const Pair loose{hi, random_of_size<double>(random, random.between(-70, -40))};
    const Pair tight = numeric::normalised(loose);
    if (value_of(tight) == value_of(loose) && tight.hi == tight.hi + tight.lo) continue;
    CAPTURE(hex(loose.hi), hex(loose.lo));
    REQUIRE(false);
  }
}

TEST_CASE("A quotient of pairs errs by less than 2^-102 of itself") {
  CAPTURE(seed);
  fuzz::Random random(seed, "quotients", 0);
  Share share("pair quotients");
  for (int round = 0; round < 60000; ++round) {
    const Pair n = random_pair(random, 200);
    Pair d = random_pair(random, 200);
    if (random.one_in(4)) d = {std::nextafter(n.hi, 0), random.one_in(2) ? 0 : -n.lo};
    const mpq_class truth = value_of(n) / value_of(d);
    if (share.admits(value_of(n / d) - truth, times_power(abs(truth), -102))) continue;
    CAPTURE(hex(n.hi), hex(n.lo), hex(d.hi), hex(d.lo));
    REQUIRE(false);
  }
  CHECK(share.greatest() > 0.02);
}

int asks_mode(int) {
  return numeric::rounds_to_nearest() ? 1 : 0;
}

TEST_CASE("The rounding mode is asked of the arithmetic itself") {
  for (const Environment& environment : environments) {
    CAPTURE(environment);
    CHECK(in_mode(environment, asks_mode, 0) == (environment.rounding == FloatMode::nearest ? 1 : 0));
  }
  CHECK(float_control() == float_control());
}

}  // namespace
}  // namespace graze::test
