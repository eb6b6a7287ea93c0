// Random integers and lattice vectors. Full mantissas, whose products are inexact, come up more often than small numbers.
#pragma once

#include "fuzz/families/integer.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz::construct {

/// A number of bits in [low, high], three times in four from the upper half; low where the interval is empty.
inline int choose_bits(Random& random, int low, int high) {
  if (high <= low) return low;
  switch (random.below(4)) {
    case 0:
      return random.between(low, high);
    case 1:
      return random.between((low + high) / 2, high);
    default:
      return random.between(high - (high - low) / 8, high);
  }
}

/// An integer in [0, 2^bits).
inline Int choose_natural(Random& random, int bits) {
  if (bits <= 0) return 0;
  const std::uint64_t high = random.bits();
  if (bits <= 64) return static_cast<Int>(high >> (64 - bits));
  const std::uint64_t low = random.bits();
  const UnsignedInt both = (static_cast<UnsignedInt>(high) << 64) | low;
  return static_cast<Int>(both >> (128 - bits));
}

/// An integer in (-2^bits, 2^bits).
inline Int choose_integer(Random& random, int bits) {
  const Int value = choose_natural(random, bits);
  return random.sign() * value;
}

/// A positive integer of just so many bits; bits >= 1.
inline Int choose_full(Random& random, int bits) {
  const Int low = choose_natural(random, bits - 1);
  return power_of_two(bits - 1) + low;
}

/// Not zero; below 2^bits in magnitude.
inline Int choose_nonzero(Random& random, int bits) {
  const Int value = choose_integer(random, bits);
  return value == 0 ? 1 : value;
}

/// Like choose_integer, three times in four not negative: a way along a ray.
inline Int choose_way(Random& random, int bits) {
  const Int value = choose_natural(random, bits);
  return random.one_in(4) ? -value : value;
}

/// A factor for a direction: 1, a power of two, or any number of at most so many bits; negative once in eight.
inline Int choose_factor(Random& random, int bits) {
  const Int sign = random.one_in(8) ? -1 : 1;
  if (bits <= 1) return sign;
  switch (random.below(4)) {
    case 0:
      return sign;
    case 1: {
      const int exponent = random.between(0, bits - 1);
      return sign * power_of_two(exponent);
    }
    default: {
      const int length = random.between(1, bits);
      return sign * choose_full(random, length);
    }
  }
}

/// A lattice vector, not zero, with coordinates below 2^bits in magnitude; some have zeros, equal or small coordinates.
inline IntVec choose_vector(Random& random, int bits) {
  IntVec v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = choose_integer(random, bits);
  const int odd_axis = random.between(0, 2);
  switch (random.below(12)) {
    case 0:
      v[odd_axis] = 0;
      break;
    case 1:
      v[odd_axis] = v[(odd_axis + 1) % 3];
      break;
    case 2:
      v[odd_axis] = random.sign();
      break;
    case 3:
      v[odd_axis] = 0;
      v[(odd_axis + 1) % 3] = 0;
      break;
    default:
      break;
  }
  if (is_zero(v)) v[odd_axis] = 1;
  return v;
}

}  // namespace graze::fuzz::construct
