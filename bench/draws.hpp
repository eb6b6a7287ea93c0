// The random numbers that one input is made of, as values: a hunt for the worst input changes them one by one, and whatever
// they are, the input keeps the condition that it was made for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "bench/source.hpp"
#include "fuzz/random.hpp"

namespace graze::bench {

class Draws {
 public:
  explicit Draws(fuzz::Random& random) {
    for (std::uint64_t& bits : bits_) bits = random.bits();
  }

  /// One number drawn anew, or changed in one bit.
  void change(fuzz::Random& random) {
    std::uint64_t& bits = bits_[random.below(used_ == 0 ? bits_.size() : used_)];
    if (random.one_in(3)) {
      bits = random.bits();
    } else {
      bits ^= std::uint64_t(1) << random.below(64);
    }
  }

  /// From the first number on.
  void rewind() { next_ = 0; }
  std::uint64_t bits() {
    const std::uint64_t bits = bits_[next_ % bits_.size()];
    used_ = std::max(used_, std::min(++next_, bits_.size()));
    return bits;
  }
  /// In [0, 1), 53 bits.
  double fraction() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In [-1, 1).
  double uniform() { return 2 * fraction() - 1; }
  double sign() { return (bits() >> 63) != 0 ? -1 : 1; }
  /// In [-n, n].
  std::int64_t integer(std::int64_t n) {
    return static_cast<std::int64_t>((bits() >> 1) % static_cast<std::uint64_t>(2 * n + 1)) - n;
  }
  Vec3<double> point() {
    const double x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }
  Vec3<double> direction() { return unit(point()); }
  /// A point of the unit ball's shell, |p| in [0, 1).
  Vec3<double> ball_point() {
    const Vec3<double> way = direction();
    return scaled(way, fraction());
  }

 private:
  std::array<std::uint64_t, 40> bits_;
  std::size_t next_ = 0, used_ = 0;
};

}  // namespace graze::bench
