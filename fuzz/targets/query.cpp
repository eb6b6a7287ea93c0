// The kernel's `intersect`, `hits` and `side` against the oracle on GMP, bit by bit, in the default floating-point mode and in
// one that the bytes choose. A disagreement is printed with the case in hexadecimal, and ends the program.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <span>

#include "fuzz/case_bytes.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/kernel_check.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
[[noreturn]] void report(const Case<T>& input, FloatMode mode, const Fault& fault) {
  const char* precision = sizeof(T) == sizeof(float) ? "float" : "double";
  const std::string line = format_case(input);
  std::fprintf(stderr, "The kernel is wrong (%s, %s):\n  %s\n  answers  %s\n  exact    %s\n", precision, name_of(mode).data(),
               line.c_str(), fault.answer.c_str(), fault.truth.c_str());
  if (mode == FloatMode::nearest) {
    std::fprintf(stderr, "  echo '%s' | graze answer --details --precision %s\n", line.c_str(), precision);
  } else {
    std::fprintf(stderr, "  replay_query FILE, with the file of these bytes: the mode is told by them\n");
  }
  std::abort();
}

template <Real T>
void check(const Case<T>& input, FloatMode other) {
  const Answer<T> truth = answer_of(oracle::gmp_oracle(), input);
  for (const FloatMode mode : {FloatMode::nearest, other}) {
    if (const auto fault = find_fault(input, truth, mode)) report(input, mode, *fault);
  }
}

}  // namespace
}  // namespace graze::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace graze::fuzz;
  const std::span bytes(data, size);
  const unsigned sum = std::accumulate(bytes.begin(), bytes.end(), 0U);
  std::visit([&](const auto& input) { check(input, float_modes[sum % float_modes.size()]); }, decode_case(bytes));
  return 0;
}
