#include "fuzz/kernel_check.hpp"

#include "fuzz/case_text.hpp"
#include "fuzz/kernel_calls.hpp"
#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
KernelAnswer<T> answer_in(FloatMode mode, const Case<T>& input) {
  const FloatModeScope scope(mode);
  return kernel_answer(input);
}

}  // namespace

template <Real T>
std::optional<Fault> find_fault(const Case<T>& input, const Answer<T>& truth, FloatMode mode) {
  const KernelAnswer<T> kernel = answer_in(mode, input);
  const bool decision_is_right = kernel.hits == is_hit(truth);
  if (decision_is_right && same_bits(kernel.answer, truth)) return std::nullopt;
  Fault fault{format_answer(input, kernel.answer, Details::yes), format_answer(input, truth, Details::yes)};
  if (!decision_is_right) fault.answer += kernel.hits ? ", and hits() is true" : ", and hits() is false";
  return fault;
}

template std::optional<Fault> find_fault(const Case<float>&, const Answer<float>&, FloatMode);
template std::optional<Fault> find_fault(const Case<double>&, const Answer<double>&, FloatMode);

}  // namespace graze::fuzz
