// Four numbers side by side: each lane is what one number by itself would be, and vectors of pairs are within their bounds.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "numeric/double_double.hpp"
#include "tests/catch.hpp"
#include "tests/support/bit_patterns.hpp"

namespace graze::test {
namespace {

using numeric::Lanes;
using numeric::Pair;
using numeric::PairLanes;

constexpr std::uint64_t seed = 256;

Lanes random_lanes(fuzz::Random& random, int spread) {
  Lanes v{};
  for (int i = 0; i < 4; ++i) v[i] = random_of_size<double>(random, random.between(-spread, spread));
  return v;
}

PairLanes random_pairs(fuzz::Random& random, int spread) {
  const Lanes a = random_lanes(random, spread);
  return numeric::two_sum(a, random_lanes(random, spread));
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST_CASE("Every lane is what one number by itself is") {
  CAPTURE(seed);
  fuzz::Random random(seed, "lanes", 0);
  for (int round = 0; round < 20000; ++round) {
    const PairLanes a = random_pairs(random, 40), b = random_pairs(random, 40);
    bool is_right = true;
    const auto check = [&](auto operation) {
      const PairLanes together = operation(a, b);
      for (int i = 0; i < 4; ++i) {
        const Pair alone = operation(Pair{a.hi[i], a.lo[i]}, Pair{b.hi[i], b.lo[i]});
        is_right = is_right && same(together.hi[i], alone.hi) && same(together.lo[i], alone.lo);
      }
    };
    check([](const auto& x, const auto& y) { return numeric::two_sum(x.hi, y.hi); });
    check([](const auto& x, const auto& y) { return numeric::two_difference(x.hi, y.hi); });
    check([](const auto& x, const auto& y) { return numeric::two_product(x.hi, y.hi); });
    check([](const auto& x, const auto& y) { return x + y; });
    check([](const auto& x, const auto& y) { return x - y; });
    check([](const auto& x, const auto& y) { return x.hi * y; });
    check([](const auto& x, const auto& y) { return x * y; });
    check([](const auto& x, const auto& y) { return x / y; });
    check([](const auto& x, const auto&) { return numeric::normalised(x); });
    CAPTURE(round);
    if (!is_right) REQUIRE(is_right);
  }
}

TEST_CASE("Lanes are turned and transposed") {
  const Lanes a{1, 2, 3, 4}, b{5, 6, 7, 8}, c{9, 10, 11, 12}, d{13, 14, 15, 16};
  const Lanes turned = numeric::rotated(a);
  const numeric::Columns columns = numeric::transposed(a, b, c, d);
  const std::array<Lanes, 4> found{columns.first, columns.second, columns.third, columns.fourth}, rows{a, b, c, d};
  const std::array<double, 4> expected{2, 3, 1, 4};
  for (int i = 0; i < 4; ++i) {
    CHECK(turned[i] == expected[static_cast<std::size_t>(i)]);
    for (int j = 0; j < 4; ++j) CHECK(found[static_cast<std::size_t>(i)][j] == rows[static_cast<std::size_t>(j)][i]);
  }
  const Lanes v = numeric::lanes(Vec3<double>{1, 2, 3}, 4);
  for (int i = 0; i < 4; ++i) CHECK(v[i] == a[i]);
}

using Exact3 = std::array<mpq_class, 3>;

Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dot(const Exact3& a, const Exact3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
mpq_class magnitude_sum(const Exact3& a) {
  return abs(a[0]) + abs(a[1]) + abs(a[2]);
}

/// A vector of pairs that is an exact difference, as those of rounding/face.cpp, and its value.
struct Difference {
  PairLanes pairs;
  Exact3 value;
};
Difference random_difference(fuzz::Random& random) {
  const Lanes a = random_lanes(random, random.between(0, 30)), b = random_lanes(random, random.between(0, 30));
  Difference d{numeric::two_difference(a, b), {}};
  for (int i = 0; i < 3; ++i) d.value[static_cast<std::size_t>(i)] = mpq_class(a[i]) - mpq_class(b[i]);
  return d;
}

TEST_CASE("A determinant of differences errs by at most 2^-100 of the product of its rows' magnitudes") {
  CAPTURE(seed);
  fuzz::Random random(seed, "determinants", 0);
  double greatest = 0;
  for (int round = 0; round < 20000; ++round) {
    Difference a = random_difference(random), b = random_difference(random);
    const Difference c = random_difference(random);
    if (random.one_in(4)) {
      // Nearly parallel: the cross product is all cancellation.
      b.pairs = a.pairs;
      b.value = a.value;
      b.pairs.lo[0] = b.pairs.lo[0] * 0.5;
      b.value[0] = mpq_class(b.pairs.hi[0]) + mpq_class(b.pairs.lo[0]);
    }
    const PairLanes product = c.pairs * numeric::cross(a.pairs, b.pairs);
    const PairLanes sum = numeric::normalised(numeric::sums(product, product, PairLanes{}, product));
    mpq_class bound = magnitude_sum(a.value) * magnitude_sum(b.value) * magnitude_sum(c.value);
    mpq_div_2exp(bound.get_mpq_t(), bound.get_mpq_t(), 100);
    const mpq_class error = mpq_class(sum.hi[0]) + mpq_class(sum.lo[0]) - dot(c.value, cross(a.value, b.value));
    greatest = std::max(greatest, mpq_class(abs(error) / bound).get_d());
    const bool is_right = abs(error) <= bound && sum.hi[2] == 0 && same(sum.hi[0], sum.hi[1]) && same(sum.lo[0], sum.lo[3]);
    CAPTURE(round);
    if (!is_right) REQUIRE(is_right);
  }
  std::printf("determinants in pairs: at most %.4f of the bound\n", greatest);
  CHECK(greatest > 0.001);
}

}  // namespace
}  // namespace graze::test
