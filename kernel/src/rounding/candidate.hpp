// The rounding test (Ziv 1991): a candidate with a bound of its error rounds for certain, or is left to the exact stage.
#pragma once

#include "numeric/double_double.hpp"

namespace graze::rounding {

/// An approximation in double-double and a bound of |approximation - value|.
struct Candidate {
  numeric::Pair value;  ///< normalised
  double error;
};

/// Sets `out` to the number nearest to the value if the whole of value +- error rounds to it, away from the subnormal and the
/// largest numbers. False, or a NaN on the way, means doubt. Asks for rounding to nearest.
template <Real T>
[[nodiscard]] inline bool rounds_certainly(const Candidate& c, T& out) noexcept {
  const auto [hi, lo] = c.value;
  // The sums below err by less than this; for double each is the rounding that is asked for.
  const double slack = sizeof(T) < sizeof(double) ? numeric::magnitude(hi) * 0x1p-52 : 0;
  const double error = c.error * (1 + 0x1p-20) + slack;
  const T below = static_cast<T>(hi + (lo - error)), above = static_cast<T>(hi + (lo + error));
  const double size = numeric::magnitude(hi);
  constexpr double least = sizeof(T) < sizeof(double) ? 0x1p-125 : 0x1p-900;
  constexpr double greatest = sizeof(T) < sizeof(double) ? 0x1p126 : 0x1p900;
  out = below;
  return below == above && size > least && size < greatest;
}

}  // namespace graze::rounding
