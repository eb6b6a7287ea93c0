// The kernel held against the GMP oracle, bit by bit, `hits` with `intersect`.
#pragma once

#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/kernel_calls.hpp"
#include "fuzz/kernel_check.hpp"
#include "fuzz/same_bits.hpp"
#include "tests/catch.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {

/// Requires that the kernel says of the case what the oracle says; returns that. Assertions are dear, so the cheap test comes
/// first.
template <Real T>
fuzz::Answer<T> require_agreement(const fuzz::Case<T>& input) {
  const fuzz::Answer<T> truth = fuzz::answer_of(oracle::gmp_oracle(), input);
  if (const auto fault = fuzz::find_fault(input, truth, FloatMode::nearest)) {
    INFO(sizeof(T) * 8 << " bits: " << fuzz::format_case(input));
    CAPTURE(fault->answer, fault->truth);
    REQUIRE(!fault.has_value());
  }
  return truth;
}

/// Requires the same in every environment, and that each is left as it was.
template <Real T>
void require_agreement_in_all_environments(const fuzz::Case<T>& input) {
  const fuzz::Answer<T> truth = fuzz::answer_of(oracle::gmp_oracle(), input);
  for (const Environment& environment : environments) {
    fuzz::KernelAnswer<T> kernel;
    bool is_kept = false;
    {
      const EnvironmentScope scope(environment);
      const FloatControl before = float_control();
      kernel = fuzz::kernel_answer(input);
      is_kept = float_control() == before;
    }
    if (is_kept && fuzz::same_bits(kernel.answer, truth) && kernel.hits == fuzz::is_hit(truth)) continue;
    INFO(sizeof(T) * 8 << " bits, " << environment << ": " << fuzz::format_case(input));
    INFO("answered " << fuzz::format_answer(input, kernel.answer, fuzz::Details::yes) << ", true is "
                     << fuzz::format_answer(input, truth, fuzz::Details::yes));
    REQUIRE(is_kept);
    REQUIRE(kernel.hits == fuzz::is_hit(truth));
    REQUIRE(fuzz::same_bits(kernel.answer, truth));
  }
}

/// The first cases of every family that ask a Query, in both formats; at least so many there are.
template <template <class> class Query>
void require_agreement_on_families(std::uint64_t cases_a_family, int least) {
  in_both_formats([&]<Real T>() {
    int count = 0;
    each_family_query<Query, T>(cases_a_family, [&](const Query<T>& query) {
      require_agreement(fuzz::Case<T>(query));
      ++count;
    });
    CHECK(count >= least);
  });
}

template <template <class> class Query>
void require_agreement_on_families_in_all_environments(std::uint64_t cases_a_family, int least) {
  in_both_formats([&]<Real T>() {
    int count = 0;
    each_family_query<Query, T>(cases_a_family, [&](const Query<T>& query) {
      require_agreement_in_all_environments(fuzz::Case<T>(query));
      ++count;
    });
    CHECK(count >= least);
  });
}

/// The same with the rounding mode set for SSE alone, where there is SSE.
template <template <class> class Query>
void require_agreement_with_sse_rounding(std::uint64_t cases_a_family) {
#if defined(__SSE2__)
  in_both_formats([&]<Real T>() {
    each_family_query<Query, T>(cases_a_family, [](const Query<T>& query) {
      const fuzz::Case<T> input(query);
      const fuzz::Answer<T> truth = fuzz::answer_of(oracle::gmp_oracle(), input);
      for (const unsigned mode : {_MM_ROUND_UP, _MM_ROUND_DOWN, _MM_ROUND_TOWARD_ZERO}) {
        fuzz::KernelAnswer<T> kernel;
        {
          const SseRoundingScope scope(mode);
          kernel = fuzz::kernel_answer(input);
        }
        const bool is_right = fuzz::same_bits(kernel.answer, truth) && kernel.hits == fuzz::is_hit(truth);
        if (is_right) continue;
        INFO(sizeof(T) * 8 << " bits, rounding by SSE " << mode << ": " << fuzz::format_case(input));
        REQUIRE(is_right);
      }
    });
  });
#else
  static_cast<void>(cases_a_family);
#endif
}

}  // namespace graze::test
