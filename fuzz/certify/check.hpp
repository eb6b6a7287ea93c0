// One case: the subject's answer, the truth, and, now and then, the second oracle's.
#pragma once

#include "fuzz/case_text.hpp"
#include "fuzz/certify/tally.hpp"
#include "fuzz/same_bits.hpp"
#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Both oracles are asked about every `second_oracle_every`-th case; 0 is never.
struct Judges {
  const Subject& subject;
  const oracle::Oracle& first;
  const oracle::Oracle& second;
  std::uint64_t second_oracle_every;
};

template <Real T>
inline constexpr const char* precision_name = sizeof(T) == sizeof(float) ? "float" : "double";

/// Judges what the subject replied to the case into the tally; returns the truth.
template <Real T>
Answer<T> check(const Judges& judges, const Case<T>& input, const Reply<T>& reply, std::uint64_t index, Tally& tally) {
  const Answer<T> truth = answer_of(judges.first, input);
  const auto describe = [&](const std::string& answer) {
    return Offender{{}, 0, precision_name<T>, format_case(input), answer, format_answer(input, truth, Details::yes)};
  };
  if (judges.second_oracle_every != 0 && index % judges.second_oracle_every == 0) {
    ++tally.oracles_compared;
    const Answer<T> second = answer_of(judges.second, input);
    if (!same_bits(truth, second)) tally.keep_oracle_difference(describe(format_answer(input, second, Details::yes)), index);
  }
  if (reply) {
    const Comparison comparison = compare(input, *reply, truth, judges.first, judges.subject.deviations());
    tally.add(comparison, index, [&] { return describe(format_answer(input, *reply, Details::yes)); });
  } else if (!reply.failure().empty()) {
    Comparison failed;
    failed.disagreement = Disagreement::failed;
    tally.add(failed, index, [&] { return describe(reply.failure()); });
  } else {
    ++tally.skipped;
  }
  return truth;
}

}  // namespace graze::fuzz
