// Small lattices, walked in strides: point n of a cube, and ranges that take turns.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "graze/types.hpp"

namespace graze::test {

/// A number in mixed radix, taken apart from its low end.
class Digits {
 public:
  explicit Digits(std::uint64_t number) : rest_(number) {}

  /// The next digit, in [0, radix).
  [[nodiscard]] int next(std::uint64_t radix) {
    const auto digit = static_cast<int>(rest_ % radix);
    rest_ /= radix;
    return digit;
  }

  /// A point of {low, ..., low + side - 1}^3.
  template <Real T>
  [[nodiscard]] Vec3<T> point(int low, std::uint64_t side) {
    const int x = next(side), y = next(side), z = next(side);
    return {T(low + x), T(low + y), T(low + z)};
  }

 private:
  std::uint64_t rest_;
};

/// The default range, ranges with ends where lattice rays meet things, one of a point, and one behind the origin.
template <Real T>
void set_range(Ray<T>& ray, std::uint64_t turn) {
  static constexpr std::array<std::array<T, 2>, 6> ranges{{{0, std::numeric_limits<T>::infinity()},
                                                           {0, 1},
                                                           {-2, T(0.5)},
                                                           {1, 1},
                                                           {T(0.5), std::numeric_limits<T>::infinity()},
                                                           {-3, -1}}};
  // The default one every other time.
  const auto& [t_min, t_max] = ranges[turn % 2 == 0 ? 0 : turn / 2 % ranges.size()];
  ray.t_min = t_min;
  ray.t_max = t_max;
}

}  // namespace graze::test
