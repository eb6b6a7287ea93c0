// Exact roots of quadratics rounded and compared, against GMP: cancellation, ties and near-ties, subnormal results, overflow.
#include <cmath>
#include <limits>

#include "exact/root.hpp"
#include "oracle/gmp_rounding.hpp"
#include "tests/catch.hpp"
#include "tests/numeric/integer_reference.hpp"
#include "tests/support/bit_patterns.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using exact::Quadratic;
using exact::QuadraticRoot;
using numeric::Dyadic;

constexpr std::uint64_t seed = 5;

/// A t^2 - 2 B t + C for t in units of 2^scale.
struct Coefficients {
  mpz_class a, b, c;
  int scale = 0;
  [[nodiscard]] mpz_class discriminant() const { return b * b - a * c; }
};

/// The sign of (b +- sqrt(d)) / a 2^scale - x.
int order_against(const Coefficients& k, int root_sign, const Dyadic& x) {
  const int exponent = x.exponent - k.scale;
  const auto up = static_cast<mp_bitcnt_t>(exponent > 0 ? exponent : 0),
             down = static_cast<mp_bitcnt_t>(exponent < 0 ? -exponent : 0);
  mpz_class m = integer_of(x.mantissa);
  if (x.negative) m = -m;
  return oracle::gmp::sign_of_root((k.b << down) - ((m * k.a) << up), root_sign, k.discriminant() << (2 * down));
}

template <int K, Real T>
std::uint64_t rounded(const QuadraticRoot<K>& root) {
  return round_to_bits(root, numeric::format_of<T>);
}

template <int K, Real T>
void check(const Coefficients& k, fuzz::Random& random) {
  const mpz_class d = k.discriminant(), limit = mpz_class(1) << (128 * K - 2);
  if (sgn(d) <= 0 || k.a >= limit || abs(k.b) >= limit || abs(k.c) >= limit) return;
  const Quadratic<K> quadratic{wrapped<2 * K>(k.a), wrapped<2 * K>(k.b), wrapped<2 * K>(k.c), wrapped<4 * K>(d), k.scale};
  for (const bool second : {false, true}) {
    const QuadraticRoot<K> root(quadratic, second);
    const int root_sign = second ? 1 : -1;
    oracle::gmp::Truncated cut;
    oracle::gmp::truncate_root(cut, k.b, root_sign, d, k.a, k.scale, oracle::gmp::kRoundingDigits<T>);
    const T expected = oracle::gmp::nearest<T>(cut);
    const Environment& environment = environments[random.below(environments.size())];
    bool is_right = in_mode(environment, rounded<K, T>, root) == numeric::bits_of(expected) && root.sign() == cut.sign;
    const T finite = std::isfinite(expected) ? expected : std::numeric_limits<T>::max();
    for (const T x :
         {finite, std::nextafter(finite, T(0)), std::nextafter(finite, 2 * finite), random_finite<T>(random), T(0)}) {
      if (!std::isfinite(x)) continue;
      is_right = is_right && numeric::compare(root, numeric::dyadic(x)) == order_against(k, root_sign, numeric::dyadic(x));
    }
    if (is_right) continue;
    CAPTURE(K, sizeof(T), second, environment, k.scale, expected);
    INFO("A " << k.a.get_str(16) << " B " << k.b.get_str(16) << " C " << k.c.get_str(16));
    REQUIRE(is_right);
  }
}

/// A magnitude of at most `bits` bits.
template <int K>
mpz_class magnitude(fuzz::Random& random, int bits) {
  const mpz_class value = abs(value_of(random_integer<2 * K>(random)));
  const auto width = static_cast<int>(mpz_sizeinbase(value.get_mpz_t(), 2));
  return width > bits ? mpz_class(value >> (width - bits)) : value;
}

template <int K>
Coefficients random_coefficients(fuzz::Random& random) {
  constexpr int w = 128 * K - 2;
  Coefficients k;
  k.a = magnitude<K>(random, random.between(1, w)) + 1;
  k.b = magnitude<K>(random, random.between(1, w)) * random.sign();
  k.c = magnitude<K>(random, random.between(1, w)) * random.sign();
  switch (random.below(8)) {
    case 0:
      k.b = 0;
      k.c = -abs(k.c);
      break;
    case 1:
      k.c = 0;
      break;
    case 2:
      k.c = random.sign();  // lost beside B^2
      break;
    case 3:
      k.a = abs(k.b) + 1;  // D = 1: the roots all but meet
      k.c = abs(k.b) - 1;
      break;
    case 4:
      k.a = random.between(1, 3);
      break;
    default:
      break;
  }
  return k;
}

/// Roots that are the middle between two numbers of the format, then off it by the least change of C or B.
template <int K, Real T>
Coefficients tie(fuzz::Random& random) {
  constexpr int digits = std::numeric_limits<T>::digits;
  const int width = random.between(1, digits);
  const std::uint64_t middle = (random.bits() >> (63 - width)) | std::uint64_t(1) << width | 1;
  const mpz_class p = integer_of(middle);
  mpz_class other = magnitude<K>(random, random.between(1, 128 * K - 80)) * random.sign();
  if (random.one_in(4)) other = p + random.between(-3, 3);
  // A even, so that B is an integer.
  const mpz_class half_a = magnitude<K>(random, random.between(1, 12)) + 1;
  Coefficients k{2 * half_a, half_a * (p + other), 2 * half_a * p * other};
  if (random.one_in(2)) k.b = -k.b;
  k.c += random.between(-1, 1);
  if (random.one_in(4)) k.b += random.sign();
  return k;
}

template <Real T>
int random_scale(fuzz::Random& random, int size) {
  using Limits = std::numeric_limits<T>;
  constexpr int least = Limits::min_exponent - Limits::digits;
  switch (random.below(3)) {
    case 0:
      return random.between(least - 3, Limits::min_exponent + 2) - size;
    case 1:
      return random.between(Limits::max_exponent - 3, Limits::max_exponent + 3) - size;
    default:
      return random.between(-60, 60) - size;
  }
}

template <int K, Real T>
void check_format(int count) {
  CAPTURE(seed);
  fuzz::Random random(seed, "roots", K * 100 + sizeof(T));
  const auto bits = [](const mpz_class& x) { return static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  for (int round = 0; round < count; ++round) {
    Coefficients k = random_coefficients<K>(random);
    k.scale = random_scale<T>(random, bits(k.b) - bits(k.a));
    check<K, T>(k, random);
    k = tie<K, T>(random);
    // The middle is that of two numbers where its last bit is one place below theirs.
    constexpr int least = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
    k.scale = random.one_in(2) ? least - 1 : random.between(least - 1, 100);
    check<K, T>(k, random);
  }
}

TEST_CASE("Roots are rounded correctly and compared exactly") {
  check_format<1, float>(20000);
  check_format<1, double>(20000);
  check_format<2, float>(8000);
  check_format<2, double>(8000);
  check_format<5, double>(3000);
  check_format<12, double>(500);
  check_format<33, float>(100);
  check_format<33, double>(150);
}

}  // namespace
}  // namespace graze::test
