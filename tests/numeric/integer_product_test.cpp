// Products of fixed-width integers against GMP: exact, for they always fit.
#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"

namespace graze::test {
namespace {

/// The value of the limbs without a sign.
template <int N>
mpz_class unsigned_value_of(const Integer<N>& a) {
  mpz_class value = value_of(a);
  if (sgn(value) < 0) value += mpz_class(1) << (64 * N);
  return value;
}

template <int N, int M>
void check_products() {
  CAPTURE(N, M, integer_seed);
  fuzz::Random random(integer_seed, "products", 1000 * N + M);
  constexpr std::uint64_t count = rounds<(N > M ? N : M)> / (N > 12 && M > 12 ? 8 : 1);
  for (std::uint64_t round = 0; round < count; ++round) {
    const Integer<N> a = random_integer<N>(random);
    const Integer<M> b = random_integer<M>(random);
    const Integer<N + M> product = a * b, unsigned_product = numeric::unsigned_product(a, b);
    const bool is_right = value_of(product) == value_of(a) * value_of(b) &&
                          same(unsigned_product, wrapped<N + M>(unsigned_value_of(a) * unsigned_value_of(b)));
    if (is_right) continue;
    INFO(value_of(a).get_str(16) << " times " << value_of(b).get_str(16));
    REQUIRE(is_right);
  }
}

template <int N>
void check_extremes() {
  const mpz_class half = mpz_class(1) << (64 * N - 1);
  for (const mpz_class& x : {mpz_class(-half), mpz_class(half - 1), mpz_class(-1), mpz_class(0), mpz_class(1)}) {
    for (const mpz_class& y : {mpz_class(-half), mpz_class(half - 1), mpz_class(-1), mpz_class(0), mpz_class(1)}) {
      CAPTURE(N, x.get_str(16), y.get_str(16));
      CHECK(value_of(wrapped<N>(x) * wrapped<N>(y)) == x * y);
    }
  }
}

TEST_CASE("Products of equal widths") {
  for_each_width([]<int N>() { check_products<N, N>(); });
}

TEST_CASE("Products with one and two limbs") {
  for_each_width([]<int N>() {
    check_products<N, 1>();
    check_products<1, N>();
    check_products<N, 2>();
    check_products<2, N>();
  });
}

TEST_CASE("Products of a vector's components with those of a cross product") {
  check_products<1, 2>();
  check_products<2, 4>();
  check_products<5, 10>();
  check_products<12, 24>();
  check_products<33, 66>();
  check_products<3, 4>();
  check_products<4, 3>();
  check_products<1, 5>();
  check_products<5, 1>();
}

TEST_CASE("Products of the least and the greatest values") {
  for_each_width([]<int N>() { check_extremes<N>(); });
}

}  // namespace
}  // namespace graze::test
