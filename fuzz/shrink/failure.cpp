#include "fuzz/shrink/failure.hpp"

#include <cmath>

#include "fuzz/case_text.hpp"

namespace graze::fuzz {
namespace {

/// The kind as the answer line has it, without values.
template <Real T>
std::string kind_of(const Case<T>& input, const Answer<T>& answer) {
  const std::string line = format_answer(input, answer);
  const std::size_t end = line.find(' ');
  return line.starts_with("invalid") ? line : line.substr(0, end);
}

}  // namespace

template <Real T>
Failure failure_of(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth, const oracle::Oracle& oracle) {
  const Comparison c = compare(input, answer, truth, oracle);
  if (c.disagreement == Disagreement::none) return {};
  const int size = !std::isfinite(c.error_ulps) ? 2 : c.error_ulps > 1 ? 1 : 0;
  return {c.disagreement, kind_of(input, answer), kind_of(input, truth), size};
}

template Failure failure_of(const Case<float>&, const Answer<float>&, const Answer<float>&, const oracle::Oracle&);
template Failure failure_of(const Case<double>&, const Answer<double>&, const Answer<double>&, const oracle::Oracle&);

}  // namespace graze::fuzz
