// The parts that families are built from, against the standard library and GMP.
#include <gmpxx.h>

#include <cmath>
#include <limits>

#include "fuzz/families/bounds.hpp"
#include "fuzz/families/choose.hpp"
#include "fuzz/families/float_bits.hpp"
#include "fuzz/families/integer.hpp"
#include "fuzz/random.hpp"
#include "tests/catch.hpp"
#include "tests/support/times_power.hpp"

namespace graze::fuzz::construct {
namespace {

using test::times_power;

mpz_class to_mpz(Int n) {
  const auto whole = static_cast<UnsignedInt>(magnitude(n));
  mpz_class value = static_cast<unsigned long>(whole >> 64);
  value <<= 64;
  value += static_cast<unsigned long>(whole);
  return n < 0 ? mpz_class(-value) : value;
}

template <Real T>
void check_scaled(Random& random) {
  const int bits = random.between(0, 100);
  const Int n = choose_integer(random, bits);
  const int exponent = random.between(least_exponent<T> - 110, end_exponent<T> + 10);
  bool exact = true;
  const T made = scaled<T>(n, exponent, exact);
  const mpq_class value = times_power(to_mpz(n), exponent);
  const mpq_class got(made);
  CAPTURE(static_cast<double>(n), exponent, made);
  REQUIRE(exact == (got == value));
  REQUIRE(abs(got) <= abs(value));
  const T outward = std::nextafter(made, n < 0 ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity());
  if (std::isfinite(outward)) REQUIRE((exact || abs(mpq_class(outward)) > abs(value)));
  const Parts back = parts(made);
  REQUIRE(times_power(to_mpz(back.mantissa), back.exponent) == got);
}

TEST_CASE("An integer times a power of two is the next number toward zero, and says whether it is exact") {
  Random random(1, "scaled", 0);
  for (int i = 0; i < 20000; ++i) {
    check_scaled<float>(random);
    check_scaled<double>(random);
  }
}

template <Real T>
void check_step(Random& random) {
  const T x = std::bit_cast<T>(static_cast<Bits<T>>(random.bits()));
  if (!std::isfinite(x)) return;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if (std::abs(x) == std::numeric_limits<T>::max()) return;
  REQUIRE(step(x, 1) == std::nextafter(x, infinity));
  REQUIRE(step(x, -1) == std::nextafter(x, -infinity));
  REQUIRE(step(step(x, 7), -7) == x);
}

TEST_CASE("A step goes to the neighbour, and stays finite") {
  Random random(2, "step", 0);
  for (int i = 0; i < 20000; ++i) {
    check_step<float>(random);
    check_step<double>(random);
  }
  CHECK(step(0.0, 1) == std::numeric_limits<double>::denorm_min());
  CHECK(step(-0.0, -1) == -std::numeric_limits<double>::denorm_min());
  CHECK(step(std::numeric_limits<float>::max(), 1) == std::numeric_limits<float>::max());
  CHECK(step(-std::numeric_limits<float>::max(), -1) == -std::numeric_limits<float>::max());
}

TEST_CASE("A number is compared exactly with a mark") {
  Random random(3, "compare", 0);
  int equal = 0;
  for (int i = 0; i < 40000; ++i) {
    const int num_bits = random.between(0, 60);
    const int den_bits = random.between(1, 60);
    const Mark mark{choose_integer(random, num_bits),
                    random.one_in(3) ? power_of_two(den_bits - 1) : choose_full(random, den_bits)};
    const int exponent = random.between(-1100, 1000);
    const Marks marks = one_mark(mark);
    const double near = guesses<double>(marks, exponent).at[0];
    const double x = step(near, random.between(-1, 1));
    const mpq_class exact = times_power(mpq_class(to_mpz(mark.num), to_mpz(mark.den)), exponent);
    mpq_class reduced = exact;
    reduced.canonicalize();
    const int expected = sgn(mpq_class(x) - reduced);
    REQUIRE(compare(x, mark, exponent) == expected);
    if (expected == 0) ++equal;
  }
  CHECK(equal > 1000);
}

TEST_CASE("Integer helpers") {
  Random random(4, "integers", 0);
  for (int i = 0; i < 20000; ++i) {
    const int bits = random.between(1, 100);
    const Int a = choose_integer(random, bits);
    const Int b = choose_integer(random, bits / 2 + 1);
    mpz_class expected;
    mpz_gcd(expected.get_mpz_t(), to_mpz(a).get_mpz_t(), to_mpz(b).get_mpz_t());
    REQUIRE(to_mpz(gcd(a, b)) == expected);
    const Bezout both = bezout(a, b);
    REQUIRE(to_mpz(both.gcd) == expected);
    REQUIRE(to_mpz(a) * to_mpz(both.x) + to_mpz(b) * to_mpz(both.y) == expected);
    REQUIRE(to_mpz(integer_sqrt(magnitude(a))) == sqrt(to_mpz(magnitude(a))));
    REQUIRE(bit_length(a) == (a == 0 ? 0 : static_cast<int>(mpz_sizeinbase(to_mpz(a).get_mpz_t(), 2))));
  }
}

TEST_CASE("Random numbers depend on seed, name and index, and stay in their intervals") {
  CHECK(Random(1, "a", 0).bits() != Random(2, "a", 0).bits());
  CHECK(Random(1, "a", 0).bits() != Random(1, "b", 0).bits());
  CHECK(Random(1, "a", 0).bits() != Random(1, "a", 1).bits());
  CHECK(Random(1, "a", 0).at(5).bits() == Random(1, "a", 5).bits());
  Random random(5, "intervals", 0);
  bool is_low = false, is_high = false;
  for (int i = 0; i < 1000; ++i) {
    const int n = random.between(-3, 4);
    REQUIRE((n >= -3 && n <= 4));
    is_low |= n == -3;
    is_high |= n == 4;
    REQUIRE(random.below(7) < 7);
  }
  CHECK((is_low && is_high));
  CHECK(random.between(4, 3) == 4);
}

}  // namespace
}  // namespace graze::fuzz::construct
