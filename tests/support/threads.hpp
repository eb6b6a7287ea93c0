// Two threads at once answer as one does.
#pragma once

#include <thread>
#include <vector>

#include "tests/support/agreement.hpp"

namespace graze::test {

/// Two threads answer the first cases of every family, one of them backward, each in an environment of its own.
template <template <class> class Query, Real T>
void require_agreement_between_threads(std::uint64_t cases_a_family) {
  std::vector<fuzz::Case<T>> cases;
  each_family_query<Query, T>(cases_a_family, [&](const Query<T>& query) { cases.emplace_back(query); });
  std::vector<fuzz::KernelAnswer<T>> alone(cases.size()), forward(cases.size()), backward(cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) alone[i] = fuzz::kernel_answer(cases[i]);
  std::thread up([&] {
    for (std::size_t i = 0; i < cases.size(); ++i) forward[i] = fuzz::kernel_answer(cases[i]);
  });
  std::thread down([&] {
    const EnvironmentScope scope({FloatMode::downward, true});
    for (std::size_t i = cases.size(); i-- > 0;) backward[i] = fuzz::kernel_answer(cases[i]);
  });
  up.join();
  down.join();
  CHECK(cases.size() > 1000);
  int different = 0;
  const auto same = [](const fuzz::KernelAnswer<T>& a, const fuzz::KernelAnswer<T>& b) {
    return fuzz::same_bits(a.answer, b.answer) && a.hits == b.hits;
  };
  for (std::size_t i = 0; i < cases.size(); ++i) different += !same(alone[i], forward[i]) || !same(alone[i], backward[i]);
  CHECK(different == 0);
}

}  // namespace graze::test
