// What is said to lie on a lattice does, in every environment of floating point; and what does is said to, in rounding to
// nearest and by a size of few bits.
#include "numeric/lattice.hpp"

#include <gmpxx.h>

#include "tests/catch.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/in_mode.hpp"
#include "tests/support/times_power.hpp"

namespace graze::test {
namespace {

constexpr std::uint64_t seed = 54;

struct Question {
  double sum, x;
};
bool is_taken(const Question& question) {
  numeric::Lattice lattice(question.sum);
  lattice.include(question.x);
  return lattice.holds_all();
}
std::int64_t steps_of(const Question& question) {
  return numeric::Lattice(question.sum).in_steps(question.x);
}

/// x / 2^exponent.
mpq_class in_units(double x, int exponent) {
  return times_power(x, -exponent);
}
bool is_multiple(double x, int exponent) {
  return in_units(x, exponent).get_den() == 1;
}

TEST_CASE("A lattice takes multiples of its step alone") {
  CAPTURE(seed);
  fuzz::Random random(seed, "lattices", 0);
  constexpr int fineness = 23;
  int taken = 0, left = 0;
  for (int round = 0; round < 60000; ++round) {
    const int exponent = random.between(-250, 250), step = exponent + fineness - 53;
    // Of few bits, or of all.
    const bool is_short = random.one_in(2);
    Question q{is_short ? static_cast<double>(random_of_size<float>(random, 0)) : random_of_size<double>(random, 0), 0};
    q.sum = std::ldexp(std::fabs(q.sum), exponent);
    // About the sum itself, of few bits or many; far below or above it; subnormal.
    q.x = random_of_size<double>(random, exponent + random.between(-40, 40));
    if (random.one_in(2)) q.x = std::ldexp(std::round(std::ldexp(q.x, -step - 2)), step + 2);
    if (random.one_in(10)) q.x = std::ldexp(random.sign(), -random.between(1023, 1074));
    for (const Environment& environment : environments) {
      const bool is_on = in_mode(environment, is_taken, q);
      ++(is_on ? taken : left);
      const bool is_to_be_on =
          environment == Environment{} && is_short && std::fabs(q.x) <= q.sum && is_multiple(q.x, step + 2);
      bool is_right = is_on ? is_multiple(q.x, step) : !is_to_be_on;
      if (is_on && std::fabs(q.x) <= q.sum) {
        const std::int64_t steps = in_mode(environment, steps_of, q);
        is_right = is_right && in_units(q.x, step) == steps && std::abs(steps) < std::int64_t(1) << 31;
      }
      if (is_right) continue;
      CAPTURE(environment, hex(q.sum), hex(q.x), is_on);
      REQUIRE(is_right);
    }
  }
  CHECK(taken > 100000);
  CHECK(left > 100000);
}

TEST_CASE("A lattice asks each number for itself") {
  for (int i = 0; i < 4; ++i) {
    numeric::Lattice lattice(8);
    lattice.include({i == 1 ? 0x1p-60 : 1, i == 2 ? 0x1p-1074 : -0.0, i == 3 ? 1 + 0x1p-52 : 0});
    CHECK(lattice.holds_all() == (i == 0));
  }
}

}  // namespace
}  // namespace graze::test
