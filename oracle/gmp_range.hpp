// The range of a ray's parameter, both ends included.
#pragma once

#include <cmath>

#include "oracle/gmp_fraction.hpp"

namespace graze::oracle::gmp {

struct Range {
  Dyadic lower, upper;
  bool bounded = false;  ///< whether `upper` counts
};

template <Real T>
[[nodiscard]] Range range_of(const Ray<T>& ray) {
  if (!is_finite(ray.t_max)) return {dyadic(ray.t_min), {}, false};
  return {dyadic(ray.t_min), dyadic(ray.t_max), true};
}

/// Whether x * 2^exponent lies in the range.
[[nodiscard]] inline bool contains(const Range& range, const Fraction& x, int exponent) {
  return compare(x, exponent, range.lower) >= 0 && (!range.bounded || compare(x, exponent, range.upper) <= 0);
}

}  // namespace graze::oracle::gmp
