// Numbers of every class of bit pattern.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fuzz/random.hpp"
#include "graze/types.hpp"

namespace graze::test {

/// All 2^16 top halves of a float, signs, exponents and leading fraction bits, each over some low halves.
template <class Visit>
void each_float_pattern(Visit visit) {
  for (std::uint32_t top = 0; top < 0x10000; ++top) {
    for (const std::uint32_t low : {0x0000u, 0x0001u, 0x5a5au, 0x8000u, 0xffffu}) {
      visit(std::bit_cast<float>(top << 16 | low));
    }
  }
}

/// All signs and exponents of a double, over fractions that are zero, one bit, all bits or random.
template <class Visit>
void each_double_pattern(Visit visit) {
  constexpr int fraction_bits = 52;
  constexpr std::uint64_t all = (std::uint64_t(1) << fraction_bits) - 1;
  fuzz::Random random(1, "double patterns", 0);
  for (std::uint64_t top = 0; top < 0x1000; ++top) {
    const auto each = [&](std::uint64_t fraction) { visit(std::bit_cast<double>(top << fraction_bits | fraction)); };
    for (const std::uint64_t fraction : {std::uint64_t(0), all, all - 1, all >> 1}) each(fraction);
    for (int bit = 0; bit < fraction_bits; bit += 3) each(std::uint64_t(1) << bit);
    for (int i = 0; i < 8; ++i) each(random.bits() & all);
  }
}

/// Both of the above.
template <class Visit>
void each_pattern(Visit visit) {
  each_float_pattern([&](float x) { visit(x); });
  each_double_pattern([&](double x) { visit(x); });
}

/// A number of any finite bit pattern.
template <Real T>
[[nodiscard]] T random_finite(fuzz::Random& random) {
  using Bits = std::conditional_t<std::same_as<T, float>, std::uint32_t, std::uint64_t>;
  while (true) {
    const T x = std::bit_cast<T>(static_cast<Bits>(random.bits()));
    if (x - x == T(0)) return x;
  }
}

/// A number of 53 or 24 random bits, its leading bit 2^exponent; now and then few bits, or all ones, or one ulp off a power of
/// two.
template <Real T>
[[nodiscard]] T random_of_size(fuzz::Random& random, int exponent) {
  constexpr int digits = std::numeric_limits<T>::digits;
  const std::uint64_t leading = std::uint64_t(1) << (digits - 1), all = leading - 1;
  std::uint64_t fraction = random.bits() & all;
  switch (random.below(8)) {
    case 0:
      fraction = 0;
      break;
    case 1:
      fraction = all - random.below(4);
      break;
    case 2:
      fraction = random.below(4);
      break;
    case 3:
      fraction = fraction << random.below(static_cast<std::uint64_t>(digits)) & all;
      break;
    default:
      break;
  }
  return std::ldexp(static_cast<T>(random.sign()) * static_cast<T>(leading + fraction), exponent - (digits - 1));
}

}  // namespace graze::test
