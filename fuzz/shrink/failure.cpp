#include "fuzz/shrink/failure.hpp"

#include <cmath>

#include "fuzz/case_text.hpp"

namespace graze::fuzz {
namespace {

/// The kind as the answer line has it, without values.
template <Real T>
std::string kind_of(const Case<T>& input, const Answer<T>& answer) {
  const std::string line = format_answer(input, answer);
  return line.starts_with("invalid") ? line : line.substr(0, line.find(' '));
}

}  // namespace

template <Real T>
Failure failure_of(const Subject& subject, const Case<T>& input) {
  const Reply<T> reply = subject.answer(input);
  if (!reply && reply.failure().empty()) return {};
  const Answer<T> truth = answer_of(oracle::gmp_oracle(), input);
  if (!reply) return {Disagreement::failed, reply.failure(), kind_of(input, truth), 0};
  const Comparison c = compare(input, *reply, truth, oracle::gmp_oracle(), subject.deviations());
  if (c.disagreement == Disagreement::none) return {};
  const int size = !std::isfinite(c.error_ulps) ? 2 : c.error_ulps > 1 ? 1 : 0;
  return {c.disagreement, kind_of(input, *reply), kind_of(input, truth), size};
}

template Failure failure_of(const Subject&, const Case<float>&);
template Failure failure_of(const Subject&, const Case<double>&);

}  // namespace graze::fuzz
