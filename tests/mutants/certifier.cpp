// What `graze certify` without options does, with whatever kernel is linked in, until the first discrepancy; tells after how
// many cases and seconds, and in which row. Exit status: 0 a discrepancy, 1 none.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "fuzz/certify/campaign.hpp"
#include "fuzz/in_float_mode.hpp"

int main() {
  using namespace graze::fuzz;
  const auto start = std::chrono::steady_clock::now();
  std::vector<InFloatMode> modes;
  modes.reserve(float_modes.size());
  Judges judges{{}, graze::oracle::gmp_oracle(), graze::oracle::cgal_oracle(), default_second_oracle_every};
  for (const FloatMode mode : float_modes) judges.subjects.push_back(&modes.emplace_back(*find_subject("graze"), mode));
  const Plan plan(default_campaign());
  Ledger ledger(plan.rows());
  std::atomic<bool> stop = false;
  Progress progress;
  progress.stop = &stop;
  // The same poll that a progress line makes.
  std::thread watch([&] {
    while (!stop && progress.discrepancies == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    stop = true;
  });
  run(plan, judges, {}, ledger, progress);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  stop = true;
  watch.join();
  const std::vector<Row> rows = ledger.rows();
  for (const Row& row : rows) {
    if (row.total().is_clean()) continue;
    std::printf("%s, %s, after %llu cases, %.1f s\n", row.name.c_str(), row.precision.c_str(),
                static_cast<unsigned long long>(progress.cases_done), seconds.count());
    return 0;
  }
  std::printf("not found in %llu cases, %.1f s\n", static_cast<unsigned long long>(progress.cases_done), seconds.count());
  return 1;
}
