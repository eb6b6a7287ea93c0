// The 128-bit integers for compilers without any, against those of the compiler that has them.
#include "numeric/portable_wide.hpp"

#include "fuzz/random.hpp"
#include "tests/catch.hpp"

#if defined(__SIZEOF_INT128__)
namespace graze::test {
namespace {

using numeric::PortableSignedWide;
using numeric::PortableWide;
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

constexpr std::uint64_t seed = 128;

/// Random, or all ones or zeros but for a few bits: carries go far.
std::uint64_t random_word(fuzz::Random& random) {
  const std::uint64_t bits = random.bits();
  switch (random.below(4)) {
    case 0:
      return std::uint64_t(1) << (bits & 63);
    case 1:
      return ~(std::uint64_t(1) << (bits & 63));
    case 2:
      return (bits & 1) != 0 ? 0 : ~std::uint64_t(0);
    default:
      return bits;
  }
}

struct Both {
  PortableWide portable;
  Wide truth;
};
Both random_wide(fuzz::Random& random) {
  const std::uint64_t low = random_word(random), high = random_word(random);
  return {{low, high}, (Wide(high) << 64) | low};
}

bool same(const PortableWide& a, Wide b) {
  return a.low == static_cast<std::uint64_t>(b) && a.high == static_cast<std::uint64_t>(b >> 64);
}
bool same(const PortableSignedWide& a, SignedWide b) {
  return same(a.bits, static_cast<Wide>(b));
}

TEST_CASE("Portable 128-bit integers are the compiler's") {
  CAPTURE(seed);
  fuzz::Random random(seed, "wide", 0);
  for (int round = 0; round < 100000; ++round) {
    const Both a = random_wide(random), b = random.one_in(8) ? a : random_wide(random);
    const int shift = random.between(0, 127), short_shift = random.between(1, 63);
    bool is_right = same(a.portable + b.portable, a.truth + b.truth) && same(a.portable - b.portable, a.truth - b.truth) &&
                    same(a.portable * b.portable, a.truth * b.truth) && same(a.portable & b.portable, a.truth & b.truth) &&
                    same(a.portable << shift, a.truth << shift) && same(a.portable >> shift, a.truth >> shift) &&
                    (a.portable < b.portable) == (a.truth < b.truth) && (a.portable == b.portable) == (a.truth == b.truth);
    const PortableSignedWide signed_a(a.portable), signed_b(b.portable);
    const auto true_a = static_cast<SignedWide>(a.truth), true_b = static_cast<SignedWide>(b.truth);
    is_right = is_right && same(signed_a + signed_b, static_cast<SignedWide>(a.truth + b.truth)) &&
               same(signed_a * signed_b, static_cast<SignedWide>(a.truth * b.truth)) &&
               same(signed_a >> short_shift, true_a >> short_shift) && (signed_a < signed_b) == (true_a < true_b) &&
               (signed_a > signed_b) == (true_a > true_b) &&
               static_cast<std::int64_t>(signed_a) == static_cast<std::int64_t>(true_a) &&
               static_cast<std::uint64_t>(signed_a) == static_cast<std::uint64_t>(true_a);
    const auto small = static_cast<std::int64_t>(a.portable.low);
    is_right = is_right && same(PortableSignedWide(small), SignedWide(small)) &&
               same(PortableSignedWide(a.portable.low), SignedWide(a.portable.low));
    if (is_right) continue;
    CAPTURE(a.portable.low, a.portable.high, b.portable.low, b.portable.high, shift, short_shift);
    REQUIRE(is_right);
  }
}

}  // namespace
}  // namespace graze::test
#endif
