// The instruction sets by which a program of the bits is to answer.
#pragma once

#include <cstdint>

#include "batch/targets.hpp"
#include "hwy/highway.h"

namespace graze::fuzz {

/// Calls f(name) for each that the processor has, or, compiled for one alone, for that; until it is false.
template <class F>
bool with_each_target(F f) {
#if defined(HWY_COMPILE_ONLY_STATIC)
  return f(hwy::TargetName(HWY_STATIC_TARGET));
#else
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().DeInit();
    if (!f(hwy::TargetName(left & -left))) return false;
  }
  return true;
#endif
}

}  // namespace graze::fuzz
