// Shifts, and numbers as integers in units of a power of two, against GMP.
#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"

namespace graze::test {
namespace {

using numeric::Dyadic;

template <int N>
void check_shift(const Integer<N>& a, int shift) {
  const mpz_class shifted = value_of(a) << static_cast<mp_bitcnt_t>(shift);
  if (same(shift_left(a, shift), wrapped<N>(shifted))) return;
  CAPTURE(N, shift);
  INFO(value_of(a).get_str(16));
  REQUIRE(same(shift_left(a, shift), wrapped<N>(shifted)));
}

TEST_CASE("A shift to the left drops what leaves the width") {
  for_each_width([]<int N>() {
    CAPTURE(integer_seed);
    fuzz::Random random(integer_seed, "shifts", N);
    // By every distance for narrow integers; by limbs, a bit off limbs and random distances for all.
    for (int shift = 0; shift <= (N <= 6 ? 64 * N + 70 : -1); ++shift) {
      for (int i = 0; i < 20; ++i) check_shift(random_integer<N>(random), shift);
    }
    for (int limbs = 0; limbs <= N + 1; ++limbs) {
      for (const int bits : {-1, 0, 1, 63, random.between(2, 62)}) {
        const int shift = 64 * limbs + bits;
        if (shift >= 0) check_shift(random_integer<N>(random), shift);
      }
    }
  });
}

TEST_CASE("A number is an integer in units of a power of two that divides it") {
  for_each_width([]<int N>() {
    CAPTURE(N, integer_seed);
    fuzz::Random random(integer_seed, "dyadic", N);
    for (int round = 0; round < 20000; ++round) {
      // At most 64 bits of mantissa, the sign of the result apart.
      const int width = random.between(1, N == 1 ? 62 : 64);
      const std::uint64_t mantissa = (random.bits() >> (64 - width)) | 1 | std::uint64_t(1) << (width - 1);
      const int unit = random.between(-3000, 3000);
      const int shift = random.one_in(3) ? 64 * random.between(0, N - 1) : random.between(0, 64 * N - 1);
      if (shift + width > 64 * N - 1) continue;
      const Dyadic x{mantissa, unit + shift, random.one_in(2)};
      mpz_class expected = integer_of(mantissa) << static_cast<mp_bitcnt_t>(shift);
      if (x.negative) expected = -expected;
      if (value_of(numeric::integer<N>(x, unit)) == expected) continue;
      CAPTURE(mantissa, shift, x.negative);
      REQUIRE(value_of(numeric::integer<N>(x, unit)) == expected);
    }
  });
}

TEST_CASE("Zero is the integer zero in whatever unit") {
  for_each_width([]<int N>() {
    for (const int unit : {-1074, 0, 1, 63, 64, 1 << 20}) {
      CHECK(numeric::integer<N>(Dyadic{}, unit).is_zero());
      CHECK(numeric::integer<N>(Dyadic{0, -1074, true}, unit).is_zero());
    }
  });
}

}  // namespace
}  // namespace graze::test
