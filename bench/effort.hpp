// How much is measured: quick is for a look, full for figures that are kept.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bench/measure.hpp"

namespace graze::bench {

struct Plan {
  const char* name;
  Effort effort;
  std::size_t timed_queries;   ///< of a mix
  std::size_t judged_queries;  ///< of a mix; of the slow entries fewer
  std::size_t level_queries;   ///< of a sweep's level
  int level_step;              ///< every so many of a sweep's levels
  int climb_steps;             ///< of the hunt for the worst case at a level
  std::uint64_t seed;
};

inline constexpr Plan quick_plan{"quick", {15, 0.0015}, 8192, 4096, 64, 2, 150, 1};
inline constexpr Plan full_plan{"full", {25, 0.01}, 16384, 16384, 256, 1, 2000, 1};

}  // namespace graze::bench
