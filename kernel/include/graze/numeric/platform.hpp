// What the kernel asks of compiler and machine, refused loudly where it is not given.
#pragma once

#include <limits>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(__ASSOCIATIVE_MATH__) || \
    defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error \
    "graze: compile without -ffast-math, -ffinite-math-only, -fassociative-math and -freciprocal-math (-fno-fast-math): \
they change the results that the error bounds are proven for."
#endif

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559,
              "graze: float and double must be IEEE-754 binary32 and binary64");
