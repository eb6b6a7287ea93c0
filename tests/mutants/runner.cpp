// Runs a kernel, mutated or not, over all families in both precisions and all floating-point modes, until it is caught.
//   mutant_NAME [--sound] [--fma] [CASES]
// CASES a family and precision, 10000 unless said otherwise; --fma: the kernel was compiled with FMA. Exit status: 0 the mutant
// was caught (--sound: nothing was), 1 not so, 2 usage error, 77 this processor cannot run it.
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdio>
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
constexpr int enough = 3;  // disagreements

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
void try_case(const Family& family, std::uint64_t index, Hunt& hunt) {
  const Case<T> input = make<T>(family, seed, index).input;
  const Answer<T> truth = answer_of(oracle::gmp_oracle(), input);
  ++hunt.cases;
  for (const FloatMode mode : float_modes) {
    const auto fault = find_fault(input, truth, mode);
    if (!fault) continue;
    report(family, index, input, mode, *fault);
    ++hunt.found;
    return;
  }
}

/// Case by case through all families at once: what a family finds soon is found soon.
Hunt hunt(std::uint64_t cases) {
  Hunt hunt;
  for (std::uint64_t index = 0; index < cases; ++index) {
    for (const Family& family : families()) {
      try_case<float>(family, index, hunt);
      try_case<double>(family, index, hunt);
      if (hunt.found >= enough) return hunt;
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

int run(bool is_sound, std::uint64_t cases) {
  const auto start = std::chrono::steady_clock::now();
  const Hunt result = hunt(cases);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::printf("%s after %llu cases, %.2f s\n", result.found > 0 ? "caught" : "nothing was found",
              static_cast<unsigned long long>(result.cases), seconds.count());
  return (result.found == 0) == is_sound ? 0 : 1;
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  bool is_sound = false;
  std::uint64_t cases = 10000;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--sound") {
      is_sound = true;
    } else if (argument == "--fma") {
      if (!graze::fuzz::has_fma()) return 77;
    } else if (const char* end = argument.data() + argument.size();
               std::from_chars(argument.data(), end, cases).ptr != end || cases == 0) {
      std::fprintf(stderr, "usage: %s [--sound] [--fma] [CASES]\n", argv[0]);
      return 2;
    }
  }
  return graze::fuzz::run(is_sound, cases);
}
