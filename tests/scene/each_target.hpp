// The SIMD targets that this machine has, one after the other.
#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace graze::test {

/// While it lives, targets are chosen by hand, for scenes that are made after.
class EachTarget {
 public:
  EachTarget() {
    for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) targets_.push_back(rest & -rest);
  }
  ~EachTarget() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
  EachTarget(const EachTarget&) = delete;
  EachTarget& operator=(const EachTarget&) = delete;

  [[nodiscard]] std::size_t size() const { return targets_.size(); }
  void choose(std::uint64_t i) const {
    hwy::SetSupportedTargetsForTest(targets_[i % targets_.size()]);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }

 private:
  std::vector<std::int64_t> targets_;
};

}  // namespace graze::test
