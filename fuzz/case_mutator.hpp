// Changes of a case that a fuzzer would hardly find among its bytes: they know what a ray is.
#pragma once

#include "fuzz/case.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz {

/// One change: a number copied, nudged by an ulp, negated or made small; numbers scaled by a power of two; the ray aimed at a
/// feature of its shape or started there; a bound put where the ray hits, by the kernel's answer.
template <Real T>
void mutate(Case<T>& input, Random& random);

}  // namespace graze::fuzz
