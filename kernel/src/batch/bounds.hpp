// The error units of lanes that compute in their inputs' own format. As numeric/filter.hpp says of double: one operation errs
// by at most `unit` relative, whatever the rounding mode, and one that underflows, or reads an input as zero, by `flushed`
// more.
//
// Sizes are asked to be so that nothing overflows: with directed rounding an overflow may give the largest finite number, and
// no infinity tells of it.
#pragma once

#include "graze/types.hpp"

namespace graze::batch {

template <Real T>
struct Bounds;

template <>
struct Bounds<float> {
  static constexpr float unit = 0x1p-23F, flushed = 0x1p-126F;
  /// Magnitudes of vectors, and of a range's bounds.
  static constexpr float low = 0x1p-24F, high = 0x1p30F;
  /// Of sums of squares of positions.
  static constexpr float most_squares = 0x1p64F;
};

template <>
struct Bounds<double> {
  static constexpr double unit = 0x1p-52, flushed = 0x1p-1022;
  static constexpr double low = 0x1p-200, high = 0x1p200;
  static constexpr double most_squares = 0x1p400;
};

}  // namespace graze::batch
