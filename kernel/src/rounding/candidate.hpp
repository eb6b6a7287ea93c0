// The rounding test (Ziv 1991): a candidate with a bound of its error rounds for certain, or is left to the exact stage.
#pragma once

#include "graze/numeric/filter.hpp"
#include "rounding/error_bounds.hpp"

namespace graze::rounding {

/// Sets `out` to the number nearest to a value within `error` of hi + lo if the whole of that interval rounds to it, away from
/// the subnormal and the largest numbers. False, or a NaN on the way, means doubt. Asks for rounding to nearest, and of an
/// error that it is at least 2^-53 |lo| above the true one, which its own sums cost (kernel/proofs/candidate.g).
template <Real T>
[[nodiscard]] inline bool rounds_certainly(double hi, double lo, double error, T& out) noexcept {
  constexpr bool is_float = sizeof(T) < sizeof(double);
  const double size = numeric::magnitude(hi);
  // For double each sum below is the rounding that is asked for; for float it errs by less than this before the rounding.
  const double slack = is_float ? size * float_sum_error : 0;
  const double margin = error * (1 + margin_share) + slack;
  const T below = static_cast<T>(hi + (lo - margin)), above = static_cast<T>(hi + (lo + margin));
  out = below;
  return (below == above) & (size > (is_float ? 0x1p-125 : 0x1p-900)) & (size < (is_float ? 0x1p126 : 0x1p900));
}

}  // namespace graze::rounding
