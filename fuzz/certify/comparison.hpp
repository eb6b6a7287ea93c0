// A subject's answer held against the truth.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "oracle/oracle.hpp"

namespace graze::fuzz {

/// The ways to disagree, the worst last.
enum class Disagreement {
  none,
  misrounded,    ///< the kind is right, a number is not the correctly rounded one
  wrong_detail,  ///< the kind is right, but not which root, the side of the origin, or the facing
  wrong_kind,    ///< both hit or both miss, but not in the same kind, side or status
  false_hit,     ///< a hit that is none
  lost_hit,      ///< no hit where there is one
  oracles,       ///< the two oracles differ: nothing is known of the subject, and the certifier is at fault
};

[[nodiscard]] std::string_view name_of(Disagreement disagreement);

struct Comparison {
  Disagreement disagreement = Disagreement::none;
  /// The greatest error of a number in units of its last place, where the kinds agree and a number is misrounded; a correctly
  /// rounded number errs by at most 1/2.
  double error_ulps = 0;
};

/// Only what has a meaning for the true kind is compared: a miss has no numbers.
template <Real T>
[[nodiscard]] Comparison compare(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth,
                                 const oracle::Oracle& oracle);

/// What the oracle answers.
template <Real T>
[[nodiscard]] Answer<T> answer_of(const oracle::Oracle& oracle, const Case<T>& input);

}  // namespace graze::fuzz
