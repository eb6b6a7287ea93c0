// Correct rounding by search: the two neighbours around an exact value, and then one comparison with their midpoint.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "oracle/cgal_values.hpp"

namespace graze::oracle::cgal {

/// The numbers >= 0 of a format in their order: rank 0 is zero, the rank after the greatest number stands for infinity.
template <Real T>
struct Ranked {
  using Rank = std::conditional_t<std::same_as<T, double>, std::uint64_t, std::uint32_t>;
  static constexpr Rank kInfinity = std::bit_cast<Rank>(std::numeric_limits<T>::infinity());

  /// The number of that rank; for infinity the power of two that would come next, so that midpoints are as for any other.
  [[nodiscard]] static Number number(Rank rank) {
    if (rank != kInfinity) return Number(std::bit_cast<T>(rank));
    return Number(std::ldexp(T(1), std::numeric_limits<T>::max_exponent - 1)) * Number(2);
  }

  /// The rank of a finite number near a guess.
  [[nodiscard]] static Rank near(double guess) {
    if (!(guess > 0)) return 0;
    constexpr T greatest = std::numeric_limits<T>::max();
    return std::bit_cast<Rank>(guess >= static_cast<double>(greatest) ? greatest : static_cast<T>(guess));
  }
};

/// The greatest rank whose number is not above a positive value.
template <Real T, class Value>
[[nodiscard]] typename Ranked<T>::Rank rank_below(const Value& value) {
  using R = Ranked<T>;
  using Rank = typename R::Rank;
  const auto reached = [&value](Rank rank) { return compare(value, R::number(rank)) != CGAL::SMALLER; };
  Rank low = R::near(guess(value));
  Rank high = low;  // the value is at or above `low`, below `high`; infinity is above everything here
  Rank step = 1;
  if (reached(low)) {
    while (high != R::kInfinity && reached(high)) {
      low = high;
      high = step < R::kInfinity - low ? low + step : R::kInfinity;
      step *= 2;
    }
  } else {
    while (!reached(low)) {
      high = low;
      low = step < high ? high - step : 0;
      step *= 2;
    }
  }
  while (high - low > 1) {
    const Rank middle = low + (high - low) / 2;
    (reached(middle) ? low : high) = middle;
  }
  return low;
}

/// The number of the format nearest to a value, ties to even, overflow to infinity, zero always positive.
template <Real T, class Value>
[[nodiscard]] T nearest(const Value& value) {
  using R = Ranked<T>;
  const CGAL::Comparison_result sign = compare(value, Number(0));
  if (sign == CGAL::EQUAL) return T(0);
  if (sign == CGAL::SMALLER) {
    const T magnitude = nearest<T>(negate(value));
    return magnitude == 0 ? T(0) : -magnitude;
  }
  auto rank = rank_below<T>(value);
  const Number midpoint = (R::number(rank) + R::number(rank + 1)) * Number(0.5);
  const CGAL::Comparison_result side = compare(value, midpoint);
  if (side == CGAL::LARGER || (side == CGAL::EQUAL && rank % 2 != 0)) ++rank;
  return std::bit_cast<T>(rank);
}

}  // namespace graze::oracle::cgal
