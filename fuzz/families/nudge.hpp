// The twins of an exact case: one or two of its numbers moved by one ulp, or a zero made tiny.
#pragma once

#include "fuzz/case.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz::construct {

enum class Nudged { anything, ray };

/// Moves one or two numbers; bounds of the ray's range take part where they are not the default. A valid case stays valid.
template <Real T>
void nudge(Case<T>& input, Random& random, Nudged what = Nudged::anything);

/// Flips the sign of some zeros, which must change nothing.
template <Real T>
void flip_zeros(Case<T>& input, Random& random);

}  // namespace graze::fuzz::construct
