// Runs a kernel, mutated or not, over all families in both precisions and all floating-point modes, until it is caught.
//   mutant_NAME [--sound] [--fma] [--one-mode] [CASES]
// CASES a family and precision, 10000 unless said otherwise; --fma: the kernel was compiled with FMA; --one-mode: only in the
// default mode, as graze certify runs, and until the first disagreement. Exit status: 0 the mutant was caught (--sound: nothing
// was), 1 not so, 2 usage error, 77 this processor cannot run it.
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/family.hpp"
#include "fuzz/kernel_check.hpp"
#include "oracle/oracle.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t seed = 1;

struct Plan {
  std::span<const FloatMode> modes = float_modes;
  int enough = 3;  ///< disagreements
  std::uint64_t cases = 10000;
};

struct Hunt {
  std::uint64_t cases = 0;
  int found = 0;
};

template <Real T>
void report(const Family& family, std::uint64_t index, const Case<T>& input, FloatMode mode, const Fault& fault) {
  std::printf("%.*s, %s, case %llu, %.*s:\n  %s\n  answers  %s\n  exact    %s\n", static_cast<int>(family.name.size()),
              family.name.data(), sizeof(T) == sizeof(float) ? "float" : "double", static_cast<unsigned long long>(index),
              static_cast<int>(name_of(mode).size()), name_of(mode).data(), format_case(input).c_str(), fault.answer.c_str(),
              fault.truth.c_str());
}

template <Real T>
void try_case(const Family& family, std::uint64_t index, const Plan& plan, Hunt& hunt) {
  const Case<T> input = make<T>(family, seed, index).input;
  const Answer<T> truth = answer_of(oracle::gmp_oracle(), input);
  ++hunt.cases;
  for (const FloatMode mode : plan.modes) {
    const auto fault = find_fault(input, truth, mode);
    if (!fault) continue;
    report(family, index, input, mode, *fault);
    ++hunt.found;
    return;
  }
}

/// Case by case through all families at once: what a family finds soon is found soon.
Hunt hunt(const Plan& plan) {
  Hunt hunt;
  for (std::uint64_t index = 0; index < plan.cases; ++index) {
    for (const Family& family : families()) {
      try_case<float>(family, index, plan, hunt);
      try_case<double>(family, index, plan, hunt);
      if (hunt.found >= plan.enough) return hunt;
    }
  }
  return hunt;
}

bool has_fma() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") != 0;
#else
  return true;
#endif
}

int run(bool is_sound, const Plan& plan) {
  const auto start = std::chrono::steady_clock::now();
  const Hunt result = hunt(plan);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%s after %llu cases, %.2f s\n", result.found > 0 ? "caught" : "nothing was found",
              static_cast<unsigned long long>(result.cases), seconds.count());
  return (result.found == 0) == is_sound ? 0 : 1;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  bool is_sound = false;
  graze::fuzz::Plan plan;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--sound") {
      is_sound = true;
    } else if (argument == "--fma") {
      if (!graze::fuzz::has_fma()) return 77;
    } else if (argument == "--one-mode") {
      plan.modes = plan.modes.first(1);
      plan.enough = 1;
    } else if (const char* end = argument.data() + argument.size();
               std::from_chars(argument.data(), end, plan.cases).ptr != end || plan.cases == 0) {
      std::fprintf(stderr, "usage: %s [--sound] [--fma] [--one-mode] [CASES]\n", argv[0]);
      return 2;
    }
  }
  return graze::fuzz::run(is_sound, plan);
}
