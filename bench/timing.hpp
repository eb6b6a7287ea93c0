// Times as ratios in one run: every contender runs in every round, interleaved, and the medians are compared.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace graze::bench {

/// One pass over its queries; returns a checksum so that no work is dropped.
struct Contender {
  std::string name;
  std::function<std::size_t()> pass;
  std::size_t queries;
};

struct Timing {
  std::string name;
  double median_ns;  ///< per query
  double least_ns, greatest_ns;
};

/// Processor time of this thread in nanoseconds: what other programs take does not count.
inline double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// Keeps the processor busy: after some idle time a virtual one was seen to take a second or two until it had its speed.
inline void warm_up() {
  for (const double start = thread_time(); thread_time() - start < 2e9;) {
  }
}

/// Nanoseconds a query for each contender: the median over `rounds` of one pass each, after one warm-up pass.
inline std::vector<Timing> race(const std::vector<Contender>& contenders, int rounds) {
  volatile std::size_t sink = 0;
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = -1; round < rounds; ++round) {
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const double start = thread_time();
      sink = sink + contenders[i].pass();
      const double took = thread_time() - start;
      if (round >= 0) times[i].push_back(took / static_cast<double>(contenders[i].queries));
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
