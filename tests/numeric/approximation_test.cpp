// Sixty-four leading bits: each step's error within what is said of it, for every true value that its inputs may stand for, in
// every environment of floating point.
#include "numeric/approximation.hpp"

#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using numeric::Approximation;
using numeric::Dyadic;

constexpr std::uint64_t seed = 4711;
constexpr std::uint64_t top_bit = std::uint64_t(1) << 63;

/// A mantissa with its top bit set: a power of two and its neighbours, near all ones, near the square root of a power of two,
/// few bits, random.
std::uint64_t random_mantissa(fuzz::Random& random) {
  constexpr std::uint64_t root_of_two = 0xb504f333f9de6484;  // sqrt(2) * 2^63
  switch (random.below(7)) {
    case 0:
      return top_bit + random.below(5);
    case 1:
      return ~random.below(5);
    case 2:
      return root_of_two - 2 + random.below(5);
    case 3:
      return top_bit | std::uint64_t(1) << random.below(64);
    case 4:
      // Around what a double still holds.
      return top_bit | (random.bits() << 11) | (random.one_in(2) ? 0x7ff : random.below(4));
    default:
      return top_bit | random.bits();
  }
}

Approximation random_approximation(fuzz::Random& random, int spread) {
  const std::uint64_t mantissa = random_mantissa(random);
  const int exponent = random.between(-spread, spread);
  return {mantissa, exponent, random.sign()};
}

struct Pair {
  Approximation first, second;
};
Approximation quotient_of(const Pair& p) {
  return quotient(p.first, p.second);
}
Approximation square_root_of(const Approximation& a) {
  return square_root(a);
}
Approximation sum_of(const Pair& p) {
  return add_magnitudes(p.first, p.second);
}

/// Whether |n / d 2^(e_n - e_d) - q| is at most `units` units of q.
bool is_quotient(const mpz_class& n, const mpz_class& d, int exponent, const Approximation& q, int units) {
  const int shift = exponent - q.exponent;
  const mpz_class scaled_n = n << (shift > 0 ? shift : 0), scaled_d = d << (shift < 0 ? -shift : 0);
  const mpz_class mantissa = integer_of(q.mantissa);
  return abs(scaled_n - mantissa * scaled_d) <= units * scaled_d;
}

TEST_CASE("A quotient is within 12 units, wherever in their slack its terms lie") {
  CAPTURE(seed);
  fuzz::Random random(seed, "quotients", 0);
  for (int round = 0; round < 40000; ++round) {
    Pair p{random_approximation(random, 2000), random_approximation(random, 2000)};
    if (random.one_in(8)) p.second.mantissa = p.first.mantissa;
    if (random.one_in(8)) p.second.mantissa = (p.first.mantissa + random.below(3) - 1) | top_bit;
    const Environment& environment = environments[random.below(environments.size())];
    const Approximation q = in_mode(environment, quotient_of, p);
    bool is_right = q.sign == p.first.sign * p.second.sign && (q.mantissa & top_bit) != 0;
    const mpz_class n = integer_of(p.first.mantissa), d = integer_of(p.second.mantissa);
    const int exponent = p.first.exponent - p.second.exponent;
    for (const int loose : {-4, 4}) {
      for (const int tight : {-1, 1}) {
        is_right = is_right && is_quotient(n + loose, d + tight, exponent, q, 12) &&
                   is_quotient(n + tight, d + loose, exponent, q, 12);
      }
    }
    // The division alone errs by 2.
    is_right = is_right && is_quotient(n, d, exponent, q, 2);
    if (is_right) continue;
    CAPTURE(environment, p.first.mantissa, p.second.mantissa, q.mantissa, q.exponent);
    REQUIRE(is_right);
  }
  CHECK(numeric::quotient({}, {top_bit, 0, -1}).sign == 0);
}

TEST_CASE("A square root is within 2 units for all that is cut to its bits") {
  CAPTURE(seed);
  fuzz::Random random(seed, "square roots", 0);
  for (int round = 0; round < 40000; ++round) {
    Approximation a = random_approximation(random, 8400);
    a.sign = 1;
    const Environment& environment = environments[random.below(environments.size())];
    const Approximation root = in_mode(environment, square_root_of, a);
    // a.mantissa 2^gap against the squares of the root's mantissa, 2 off to either side.
    const int gap = a.exponent - 2 * root.exponent;
    bool is_right = root.sign == 1 && (root.mantissa & top_bit) != 0 && gap >= 0;
    if (is_right) {
      const mpz_class least = integer_of(a.mantissa) << static_cast<mp_bitcnt_t>(gap);
      const mpz_class most = (integer_of(a.mantissa) + 1) << static_cast<mp_bitcnt_t>(gap);
      const mpz_class low = integer_of(root.mantissa) - 2, high = integer_of(root.mantissa) + 2;
      is_right = low * low <= least && high * high >= most;
    }
    if (is_right) continue;
    CAPTURE(environment, a.mantissa, a.exponent, root.mantissa, root.exponent);
    REQUIRE(is_right);
  }
  CHECK(square_root(Approximation{}).sign == 0);
}

TEST_CASE("A sum of leading bits and of a root is within 4 units") {
  CAPTURE(seed);
  fuzz::Random random(seed, "sums", 0);
  for (int round = 0; round < 40000; ++round) {
    Pair p{random_approximation(random, 40), random_approximation(random, 40)};
    p.second.sign = 1;
    const Approximation sum = in_mode(Environment{}, sum_of, p);
    const int low = std::min({p.first.exponent, p.second.exponent, sum.exponent});
    const auto at = [&](const mpz_class& mantissa, int exponent) {
      return mpz_class(mantissa << static_cast<mp_bitcnt_t>(exponent - low));
    };
    const mpz_class found = at(integer_of(sum.mantissa), sum.exponent), unit = at(1, sum.exponent);
    bool is_right = sum.sign == p.first.sign && (sum.mantissa & top_bit) != 0;
    for (const int a : {0, 1}) {
      for (const int b : {-2, 2}) {
        const mpz_class truth =
            at(integer_of(p.first.mantissa) + a, p.first.exponent) + at(integer_of(p.second.mantissa) + b, p.second.exponent);
        is_right = is_right && abs(truth - found) <= 4 * unit;
      }
    }
    if (is_right) continue;
    CAPTURE(p.first.mantissa, p.first.exponent, p.second.mantissa, p.second.exponent, sum.mantissa, sum.exponent);
    REQUIRE(is_right);
  }
}

TEST_CASE("A sum with zero is the other term, and the sign of zero counts as positive") {
  const Approximation zero, minus{top_bit + 5, -7, -1}, plus{top_bit + 3, 9, 1};
  CHECK(add_magnitudes(minus, zero).mantissa == minus.mantissa);
  CHECK(add_magnitudes(minus, zero).sign == -1);
  CHECK(add_magnitudes(zero, plus).mantissa == plus.mantissa);
  CHECK(add_magnitudes(zero, plus).exponent == 9);
  CHECK(add_magnitudes(zero, plus).sign == 1);
}

TEST_CASE("The leading bits are cut, not rounded") {
  for_each_width([]<int N>() {
    CAPTURE(N, seed);
    fuzz::Random random(seed, "leading", N);
    for (int round = 0; round < 4000; ++round) {
      const Integer<N> a = random_integer<N>(random);
      const mpz_class value = value_of(a), size = abs(value);
      const Approximation found = leading(a);
      bool is_right = found.sign == sgn(value);
      if (sgn(value) != 0) {
        const auto width = static_cast<int>(mpz_sizeinbase(size.get_mpz_t(), 2));
        const int exponent = width - 64;
        const mpz_class cut = exponent >= 0 ? mpz_class(size >> exponent) : mpz_class(size << -exponent);
        is_right = is_right && found.exponent == exponent && integer_of(found.mantissa) == cut;
      }
      if (is_right) continue;
      INFO(value.get_str(16));
      REQUIRE(is_right);
    }
  });
}

TEST_CASE("A comparison that tells is right for all that the bits may stand for") {
  CAPTURE(seed);
  fuzz::Random random(seed, "comparisons", 0);
  int undecided = 0;
  constexpr int count = 60000;
  for (int round = 0; round < count; ++round) {
    const Approximation a = random_approximation(random, 200);
    // A number of up to 54 bits near it, or anywhere.
    const auto offset = static_cast<std::uint64_t>(random.between(-70, 70)) * random.below(40);
    Dyadic x{(random.one_in(2) ? a.mantissa : a.mantissa + offset) >> random.between(10, 40), 0, a.sign < 0};
    const int cut = std::countl_zero(x.mantissa) + (random.one_in(6) ? random.between(-1, 1) : 0);
    x.exponent = a.exponent + cut;
    if (random.one_in(16)) x.negative = !x.negative;
    const int order = compare(a, x);
    const int low = std::min(a.exponent, x.exponent);
    const mpz_class right = (x.negative ? -1 : 1) * (integer_of(x.mantissa) << static_cast<mp_bitcnt_t>(x.exponent - low));
    bool is_right = true;
    int orders[2];
    for (const int side : {0, 1}) {
      const int slack = (side == 0 ? -1 : 1) * static_cast<int>(Approximation::slack);
      const mpz_class left = a.sign * ((integer_of(a.mantissa) + slack) << static_cast<mp_bitcnt_t>(a.exponent - low));
      orders[side] = cmp(left, right);
      if (order != 0) is_right = is_right && (orders[side] > 0) - (orders[side] < 0) == order;
      // Undecided only where the value is that near, within a few times its slack.
      const mpz_class unit = mpz_class(1) << static_cast<mp_bitcnt_t>(a.exponent - low);
      if (order == 0) is_right = is_right && abs(left - right) <= 64 * unit;
    }
    undecided += order == 0;
    if (is_right) continue;
    CAPTURE(a.mantissa, a.exponent, a.sign, x.mantissa, x.exponent, x.negative, order);
    REQUIRE(is_right);
  }
  CHECK(undecided > count / 20);
  CHECK(undecided < count * 3 / 4);
  CHECK(compare(Approximation{}, Dyadic{}) == 0);
  CHECK(compare(Approximation{}, Dyadic{1, -1074, false}) == -1);
  CHECK(compare(Approximation{}, Dyadic{1, -1074, true}) == 1);
}

}  // namespace
}  // namespace graze::test
