// The simplest case that still fails.
#pragma once

#include <cstdint>
#include <functional>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// Whether a case fails in the way that is to be kept. A function of the case alone.
template <Real T>
using Fails = std::function<bool(const Case<T>&)>;

template <Real T>
struct Shrunk {
  Case<T> input;
  std::uint64_t trials = 0;  ///< how often `fails` was asked
  bool is_minimal = true;    ///< false where the trials ran out before every change had been tried
};

inline constexpr std::uint64_t default_trials = 200000;

/// How far from simple a case is; 0 is all zeros with the default range. Lower is simpler: each number that is not zero, each
/// significant bit, each step of a power of two away from units, each sign, and NaN and infinity above all finite numbers.
template <Real T>
[[nodiscard]] std::uint64_t complexity(const Case<T>& input);

/// From a case that fails, by changes that each lower its complexity and keep it failing, until no change does. So the result
/// is minimal in this sense: no number of it can be made zero, a smaller integer, shorter by any number of its last bits, one
/// of a lesser exponent or positive, no point can become the origin by a translation, and no part of it (positions, direction,
/// ends of the range, all) can be scaled or rounded to fewer bits, without losing the failure. Deterministic.
template <Real T>
[[nodiscard]] Shrunk<T> shrink(const Case<T>& input, const Fails<T>& fails, std::uint64_t trials = default_trials);

}  // namespace graze::fuzz
