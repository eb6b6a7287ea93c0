// One case: the truth, now and then by the second oracle too, and the subject's answer in each floating-point mode.
#pragma once

#include <vector>

#include "fuzz/case_text.hpp"
#include "fuzz/certify/tally.hpp"
#include "fuzz/same_bits.hpp"
#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Both oracles are asked about every `second_oracle_every`-th case; 0 is never.
struct Judges {
  std::vector<const Subject*> subjects;  ///< one kernel, once for each floating-point mode in which it is asked
  const oracle::Oracle& first;
  const oracle::Oracle& second;
  std::uint64_t second_oracle_every;
};

template <Real T>
inline constexpr const char* precision_name = sizeof(T) == sizeof(float) ? "float" : "double";

/// replies[m][i] of subject m to case i.
template <Real T>
using Replies = std::vector<std::vector<Reply<T>>>;

template <Real T>
[[nodiscard]] Replies<T> ask(const Judges& judges, const std::vector<Case<T>>& inputs) {
  Replies<T> replies;
  for (const Subject* subject : judges.subjects) {
    replies.emplace_back(inputs.size());
    subject->answer(std::span<const Case<T>>(inputs), std::span(replies.back()));
  }
  return replies;
}

/// Judges what the subjects replied to the case, the i-th of `replies`, into the tally; returns the truth.
template <Real T>
Answer<T> check(const Judges& judges, const Case<T>& input, const Replies<T>& replies, std::size_t i, std::uint64_t index,
                Tally& tally) {
  const Answer<T> truth = answer_of(judges.first, input);
  const auto describe = [&](FloatMode mode, const std::string& answer) {
    return Offender{{}, 0, precision_name<T>, mode, format_case(input), answer, format_answer(input, truth, Details::yes)};
  };
  if (judges.second_oracle_every != 0 && index % judges.second_oracle_every == 0) {
    ++tally.oracles_compared;
    const Answer<T> second = answer_of(judges.second, input);
    if (!same_bits(truth, second)) {
      tally.keep_oracle_difference(describe(FloatMode::nearest, format_answer(input, second, Details::yes)), index);
    }
  }
  Comparison worst, comparison;
  std::size_t of_worst = 0;
  for (std::size_t m = 0; m < replies.size(); ++m) {
    const Reply<T>& reply = replies[m][i];
    if (!reply && reply.failure().empty()) {
      ++tally.skipped;
      continue;
    }
    // Most often it is the answer of the mode before.
    if (m == 0 || !reply || !replies[m - 1][i] || !same_bits(*reply, *replies[m - 1][i])) {
      comparison = {};
      comparison.disagreement = Disagreement::failed;
      if (reply) comparison = compare(input, *reply, truth, judges.first, judges.subjects[m]->deviations());
    }
    tally.count_in(comparison);
    if (!comparison.is_worse_than(worst)) continue;
    worst = comparison;
    of_worst = m;
  }
  // A case that fails in all modes is told once.
  tally.offer(worst, index, [&] {
    const Reply<T>& reply = replies[of_worst][i];
    return describe(judges.subjects[of_worst]->float_mode(),
                    reply ? format_answer(input, *reply, Details::yes) : reply.failure());
  });
  return truth;
}

}  // namespace graze::fuzz
