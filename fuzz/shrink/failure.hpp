// In which way a subject fails on a case: what a shrinker keeps.
#pragma once

#include <string>

#include "fuzz/certify/comparison.hpp"
#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Two failures are the same way of failing where all of this agrees.
struct Failure {
  Disagreement disagreement = Disagreement::none;
  std::string answered, exact;  ///< the words of the kinds or signs, with the status of invalid input
  /// Of a number's error: 0 up to one unit in the last place, 1 more, 2 not a number or infinitely off.
  int size = 0;

  [[nodiscard]] bool is_failure() const { return disagreement != Disagreement::none; }
  bool operator==(const Failure&) const = default;
};

/// What the subject gets wrong, beyond what it declares; no failure where it is right or does not offer the query.
template <Real T>
[[nodiscard]] Failure failure_of(const Subject& subject, const Case<T>& input);

}  // namespace graze::fuzz
