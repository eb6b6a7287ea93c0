// The rounding test never vouches for a number that a value within the error would not round to.
#include "rounding/candidate.hpp"

#include <gmpxx.h>

#include <cmath>
#include <limits>

#include "tests/catch.hpp"
#include "tests/numeric/nearest.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

constexpr std::uint64_t seed = 1991;

struct Candidate {
  double hi, lo, error;
};

/// The verdict and its number.
template <Real T>
struct Verdict {
  bool is_certain;
  T number;
};
template <Real T>
Verdict<T> judge(const Candidate& c) {
  Verdict<T> verdict{};
  verdict.is_certain = rounding::rounds_certainly(c.hi, c.lo, c.error, verdict.number);
  return verdict;
}

/// The rounding stage's bounds are never below this share of the value, and each has room for what rounding lo + error costs:
/// this share of lo.
constexpr double least_share = 0x1p-102, room = 0x1p-53;

/// A pair near or on the middle between two numbers of the format, or far from one, and an error that reaches it, or not quite.
template <Real T>
Candidate random_candidate(fuzz::Random& random) {
  constexpr int digits = std::numeric_limits<T>::digits;
  const int spread = random.one_in(4) ? 1030 : 20;
  Candidate c{random_of_size<double>(random, random.between(-spread, spread)), 0, 0};
  const int size = std::ilogb(c.hi);
  const double half = std::ldexp(random.sign(), size - digits);
  if (digits < 53 && random.one_in(2)) c.hi = static_cast<double>(static_cast<T>(c.hi)) + half;
  const int gap = random.between(1, 60);
  c.lo = digits == 53 && random.one_in(2) ? half * (1 - std::ldexp(1.0, -gap)) : std::ldexp(half, -gap);
  if (!std::isfinite(c.hi) || std::fabs(c.lo) > std::ldexp(1.0, size - 53)) c.lo = 0;
  const double hi = c.hi + c.lo;
  c.lo = c.lo - (hi - c.hi);
  c.hi = hi;
  const double least = std::fabs(c.hi) * least_share;
  const double to_middle = std::fabs(half - c.lo), reach = random.one_in(2) ? to_middle : std::fabs(c.lo);
  c.error = random.one_in(3) ? std::ldexp(std::fabs(c.hi), -random.between(20, 100)) : reach;
  for (int i = random.between(-3, 3); i != 0; i += i < 0 ? 1 : -1) c.error = std::nextafter(c.error, i < 0 ? 0 : 1e300);
  c.error = std::fmax(c.error, least);
  return c;
}

template <Real T>
void check(int count) {
  CAPTURE(seed, sizeof(T));
  fuzz::Random random(seed, "candidates", sizeof(T));
  int certain = 0, in_doubt = 0;
  for (int round = 0; round < count; ++round) {
    const Candidate c = random_candidate<T>(random);
    if (!std::isfinite(c.hi)) continue;
    for (const bool flushes : {false, true}) {
      const Verdict<T> verdict = in_mode({FloatMode::nearest, flushes}, judge<T>, c);
      ++(verdict.is_certain ? certain : in_doubt);
      if (!verdict.is_certain) continue;
      const mpq_class middle = mpq_class(c.hi) + mpq_class(c.lo);
      const mpq_class error = mpq_class(c.error) - abs(mpq_class(c.lo)) * room;
      const mpq_class low = middle - error, high = middle + error;
      const bool is_right = nearest<T>(low.get_num(), low.get_den()) == verdict.number &&
                            nearest<T>(high.get_num(), high.get_den()) == verdict.number;
      if (is_right) continue;
      CAPTURE(flushes, hex(c.hi), hex(c.lo), hex(c.error), hex(verdict.number));
      REQUIRE(is_right);
    }
  }
  CHECK(certain > count / 5);
  CHECK(in_doubt > count / 5);
}

TEST_CASE("What the rounding test vouches for is right over the whole error") {
  check<float>(100000);
  check<double>(100000);
}

TEST_CASE("NaNs, and numbers near the ends of the range, are in doubt") {
  in_both_formats([]<Real T>() {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const Candidate& c : {Candidate{nan, 0, 0x1p-60}, Candidate{1, nan, 0x1p-60}, Candidate{1, 0, nan},
                               Candidate{infinity, 0, 1}, Candidate{1, 0, infinity}, Candidate{0, 0, 0},
                               Candidate{0, 0, 0x1p-60}, Candidate{0x1p-1000, 0, 0}, Candidate{0x1p1000, 0, 0}}) {
      CAPTURE(hex(c.hi), hex(c.lo), hex(c.error));
      CHECK(!judge<T>(c).is_certain);
    }
    const double small = std::numeric_limits<T>::min(), large = std::numeric_limits<T>::max();
    CHECK(!judge<T>({small, 0, 0}).is_certain);
    CHECK(!judge<T>({large, 0, 0}).is_certain);
    CHECK(judge<T>({-1.5, 0, 0x1p-60}).is_certain);
    CHECK(judge<T>({-1.5, 0, 0x1p-60}).number == T(-1.5));
  });
}

}  // namespace
}  // namespace graze::test
