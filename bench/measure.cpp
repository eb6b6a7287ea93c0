#include "bench/measure.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <map>

namespace graze::bench {
namespace {

/// Keeps every repetition's processor time of an iteration, in ns.
class Keeper final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }
  }
  [[nodiscard]] const std::vector<double>& of(const std::string& name) const { return times_.at(name); }

 private:
  std::map<std::string, std::vector<double>> times_;
};

void set_flags(const Effort& effort) {
  std::vector<std::string> words{"bench", "--benchmark_enable_random_interleaving=true",
                                 "--benchmark_repetitions=" + std::to_string(effort.repetitions),
                                 "--benchmark_min_time=" + std::to_string(effort.least_seconds)};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (count != 1) {
    std::fprintf(stderr, "this Google Benchmark does not interleave: 1.6 or later is needed\n");
    std::exit(2);
  }
}

}  // namespace

std::vector<std::vector<double>> measure(const std::vector<Contest>& contests, const Effort& effort) {
  set_flags(effort);
  // Numbers as names: what a name holds is read as a filter elsewhere.
  for (std::size_t i = 0; i < contests.size(); ++i) {
    benchmark::RegisterBenchmark(std::to_string(i).c_str(), [&contests, i](benchmark::State& state) {
      for (auto _ : state) benchmark::DoNotOptimize(contests[i].pass());
    })->Unit(benchmark::kNanosecond);
  }
  Keeper keeper;
  benchmark::RunSpecifiedBenchmarks(&keeper);
  benchmark::ClearRegisteredBenchmarks();
  std::vector<std::vector<double>> out;
  for (std::size_t i = 0; i < contests.size(); ++i) {
    out.push_back(keeper.of(std::to_string(i)));
    for (double& ns : out.back()) ns /= static_cast<double>(contests[i].queries);
  }
  return out;
}

}  // namespace graze::bench
