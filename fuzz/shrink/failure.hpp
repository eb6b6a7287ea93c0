// In which way an answer is wrong: what a shrinker keeps.
#pragma once

#include <compare>
#include <string>

#include "fuzz/certify/comparison.hpp"

namespace graze::fuzz {

/// Two failures are the same way of failing where all of this agrees.
struct Failure {
  Disagreement disagreement = Disagreement::none;
  std::string answered, exact;  ///< the words of the kinds or signs, with the status of invalid input
  /// Of a number's error: 0 below one unit in the last place, 1 more, 2 not a number or infinitely off.
  int size = 0;

  [[nodiscard]] bool is_failure() const { return disagreement != Disagreement::none; }
  bool operator==(const Failure&) const = default;
};

template <Real T>
[[nodiscard]] Failure failure_of(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth,
                                 const oracle::Oracle& oracle);

}  // namespace graze::fuzz
