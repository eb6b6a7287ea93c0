// Sums, signs and comparisons of fixed-width integers against GMP, wrapping included.
#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"

namespace graze::test {
namespace {

/// Calls check(a, b, value of a, value of b) on pairs; a pair that it denies is told.
template <int N, class Check>
void each_pair(Check check) {
  CAPTURE(N, integer_seed);
  fuzz::Random random(integer_seed, "pairs", N);
  for (std::uint64_t round = 0; round < rounds<N>; ++round) {
    const Integer<N> a = random_integer<N>(random);
    const Integer<N> b = random.one_in(8) ? a : random_integer<N>(random);
    const mpz_class x = value_of(a), y = value_of(b);
    if (check(a, b, x, y)) continue;
    INFO(x.get_str(16) << " and " << y.get_str(16));
    REQUIRE(false);
  }
}

TEST_CASE("Sums and differences wrap as two's complement does") {
  for_each_width([]<int N>() {
    each_pair<N>([](const Integer<N>& a, const Integer<N>& b, const mpz_class& x, const mpz_class& y) {
      Integer<N> in_place = a;
      numeric::subtract_from(in_place.limb, b);
      return same(a + b, wrapped<N>(x + y)) && same(a - b, wrapped<N>(x - y)) && same(in_place, wrapped<N>(x - y));
    });
  });
}

TEST_CASE("Negation and magnitude, the least value included") {
  for_each_width([]<int N>() {
    each_pair<N>([](const Integer<N>& a, const Integer<N>&, const mpz_class& x, const mpz_class&) {
      return same(-a, wrapped<N>(-x)) && same(numeric::negate_if(true, a), wrapped<N>(-x)) &&
             same(numeric::negate_if(false, a), a) && same(abs(a), wrapped<N>(abs(x)));
    });
    // The least value is its own negative; read without a sign it is its magnitude.
    const Integer<N> least = wrapped<N>(mpz_class(1) << (64 * N - 1));
    CHECK(same(abs(least), least));
    CHECK(least.is_negative());
  });
}

TEST_CASE("Signs and comparisons") {
  for_each_width([]<int N>() {
    each_pair<N>([](const Integer<N>& a, const Integer<N>& b, const mpz_class& x, const mpz_class& y) {
      const int order = cmp(x, y);
      return a.sign() == sgn(x) && a.is_zero() == (sgn(x) == 0) && a.is_negative() == (sgn(x) < 0) &&
             compare(a, b) == (order > 0) - (order < 0);
    });
  });
}

TEST_CASE("Neighbours are told apart in the lowest limb") {
  for_each_width([]<int N>() {
    each_pair<N>([](const Integer<N>& a, const Integer<N>&, const mpz_class& x, const mpz_class&) {
      const Integer<N> next = wrapped<N>(x + 1);
      // The greatest value has no neighbour above: it wraps to the least.
      const bool wraps = x + 1 == mpz_class(1) << (64 * N - 1);
      return compare(a, next) == (wraps ? 1 : -1) && compare(next, a) == (wraps ? -1 : 1) && compare(a, a) == 0;
    });
  });
}

TEST_CASE("A wider integer has the same value") {
  for_each_width([]<int N>() {
    each_pair<N>([](const Integer<N>& a, const Integer<N>&, const mpz_class& x, const mpz_class&) {
      return same(numeric::extend<N>(a), a) && value_of(numeric::extend<N + 1>(a)) == x &&
             value_of(numeric::extend<2 * N + 2>(a)) == x;
    });
  });
}

}  // namespace
}  // namespace graze::test
