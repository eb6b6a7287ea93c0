// Times by Google Benchmark: its loop, its calibration of iterations and its random interleaving of repetitions, so that what
// disturbs the machine falls on all contenders alike. It tells means of repetitions; the medians and their spread are ours,
// from every repetition's time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace graze::bench {

struct Contest {
  std::string name;
  std::function<std::size_t()> pass;
  std::size_t queries;  ///< of a pass
};

/// How long each is measured.
struct Effort {
  int repetitions;
  double least_seconds;  ///< of a repetition
};

/// Processor time in ns a query, one number a repetition, in the order of `contests`.
[[nodiscard]] std::vector<std::vector<double>> measure(const std::vector<Contest>& contests, const Effort& effort);

}  // namespace graze::bench
