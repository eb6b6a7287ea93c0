// The kernel's `intersect`, `hits` and `side` against the oracle on GMP, bit by bit, in the default floating-point mode and in
// one that the bytes choose. A disagreement is shrunk, printed as a case file, and ends the program.
#include "fuzz/targets/case_target.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <span>

#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/kernel_check.hpp"
#include "fuzz/shrink/shrink.hpp"

namespace graze::fuzz {
namespace {

/// Sanitizers take their time, and a case under a fuzzer is small.
constexpr std::uint64_t trials = 20000;

std::string_view kind_of(std::string_view answer_line) {
  return answer_line.substr(0, answer_line.find_first_of(" ,"));
}

template <Real T>
std::optional<Fault> fault_of(const Case<T>& input, FloatMode mode) {
  return find_fault(input, answer_of(oracle::gmp_oracle(), input), mode);
}

/// With the same kinds, and the same word about `hits`.
template <Real T>
Case<T> shrunk(const Case<T>& input, FloatMode mode, const Fault& fault) {
  const bool is_about_hits = fault.answer.find("hits()") != std::string::npos;
  const Fails<T> fails = [&](const Case<T>& candidate) {
    const auto other = fault_of(candidate, mode);
    return other && kind_of(other->answer) == kind_of(fault.answer) && kind_of(other->truth) == kind_of(fault.truth) &&
           (other->answer.find("hits()") != std::string::npos) == is_about_hits;
  };
  return shrink(input, fails, trials).input;
}

template <Real T>
[[noreturn]] void report(const Case<T>& input, FloatMode mode, const Fault& fault) {
  const char* precision = sizeof(T) == sizeof(float) ? "float" : "double";
  std::fprintf(stderr, "# The kernel is wrong (%s, %s), found with\n#   %s\n#   answers  %s\n#   exact    %s\n", precision,
               name_of(mode).data(), format_case(input).c_str(), fault.answer.c_str(), fault.truth.c_str());
  const Case<T> simplest = shrunk(input, mode, fault);
  const Fault simple = fault_of(simplest, mode).value_or(fault);
  std::fprintf(stderr, "# The simplest case that fails so\n#   answers  %s\n#   exact    %s\n", simple.answer.c_str(),
               simple.truth.c_str());
  std::fprintf(stderr,
               mode == FloatMode::nearest
                   ? "# Replay: graze answer --details --precision %s FILE, with FILE this one.\n"
                   : "# Replay: as bytes, by the program that found it, for in the default rounding mode it may pass (%s).\n",
               precision);
  std::fprintf(stderr, "%s\n", format_case(simplest).c_str());
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
  const FloatMode other = float_modes[sum % float_modes.size()];
  std::visit([&](const auto& input) { check(input, other); }, decode_case(target_group, bytes));
  return 0;
}
