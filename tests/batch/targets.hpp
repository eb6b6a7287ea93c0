// Every instruction set that the batches are compiled for and this processor has.
#pragma once

#include <cstdint>
#include <string>

#include "batch/targets.hpp"
#include "hwy/highway.h"

namespace graze::test {

/// Calls f(name) with each instruction set chosen in turn, and last with the best.
template <class F>
void with_each_target(F f) {
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    const std::int64_t target = left & -left;
    // The compiler's own target is always left as the last choice.
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    f(std::string(hwy::TargetName(target)));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace graze::test
