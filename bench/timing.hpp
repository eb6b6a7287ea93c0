// Times as ratios in one run: every contender runs in every round, interleaved, and the medians are compared.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace graze::bench {

/// One pass over all inputs; returns a checksum so that no work is dropped.
struct Contender {
  std::string name;
  std::function<std::size_t()> pass;
};

struct Timing {
  std::string name;
  double median_ns;   ///< per query
  double least_ns, greatest_ns;
};

/// Nanoseconds a query for each contender: the median over `rounds` of one pass each, after one warm-up pass.
inline std::vector<Timing> race(const std::vector<Contender>& contenders, std::size_t queries, int rounds) {
  volatile std::size_t sink = 0;
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const auto start = std::chrono::steady_clock::now();
      sink = sink + contenders[i].pass();
      const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
      if (round >= 0) times[i].push_back(took.count() / static_cast<double>(queries));
    }
  }
  std::vector<Timing> out;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    std::vector<double>& t = times[i];
    std::sort(t.begin(), t.end());
    out.push_back({contenders[i].name, t[t.size() / 2], t.front(), t.back()});
  }
  return out;
}

}  // namespace graze::bench
