// A subject's answer held against the truth.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "oracle/oracle.hpp"

namespace graze::fuzz {

/// The ways to disagree, the worst last.
enum class Disagreement {
  none,
  invalid_handling,  ///< invalid input is not answered by its status
  misrounded,        ///< the kind is right, a number is farther off than the subject declares; a NaN is infinitely far
  wrong_detail,      ///< the kind is right, but not which root, the side of the origin, or the facing
  wrong_order,       ///< the kind is right, the roots are not ascending
  wrong_kind,        ///< both hit or both miss, but not in the same kind, side or status, or not with as many roots
  false_hit,         ///< a hit that is none
  lost_hit,          ///< no hit where there is one
  failed,            ///< no answer: the subject crashed, hung, or answered what is none
  oracles,           ///< the two oracles differ: nothing is known of the subject, and the certifier is at fault
};
inline constexpr std::size_t disagreement_count = 10;

[[nodiscard]] std::string_view name_of(Disagreement disagreement);

struct Comparison {
  Disagreement disagreement = Disagreement::none;
  /// The greatest error of a number in units of its last place, where numbers were compared and one is not the correctly
  /// rounded one, declared or not; a correctly rounded number errs by at most 1/2.
  double error_ulps = 0;
  bool has_numbers = false;  ///< numbers were compared
  DeviationSet allowed;      ///< what would have been a disagreement but is declared

  [[nodiscard]] bool is_worse_than(const Comparison& other) const {
    return disagreement != other.disagreement ? disagreement > other.disagreement : error_ulps > other.error_ulps;
  }
};

/// Only what has a meaning for the true kind is compared: a miss has no numbers. What the subject declares is allowed for.
template <Real T>
[[nodiscard]] Comparison compare(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth,
                                 const oracle::Oracle& oracle, const Deviations& declared = {});

/// What the oracle answers.
template <Real T>
[[nodiscard]] Answer<T> answer_of(const oracle::Oracle& oracle, const Case<T>& input);

}  // namespace graze::fuzz
