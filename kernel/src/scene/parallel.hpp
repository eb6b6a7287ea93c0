// Work on all cores where oneTBB is there and the caller allows it.
#pragma once

#include <array>
#include <cstddef>

#include "graze/scene/query.hpp"

#if defined(GRAZE_HAVE_TBB)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace graze::scene {

/// Calls f(begin, end) for parts that make up [0, n), each of at least `grain` where there are so many.
template <class F>
inline void for_ranges(std::size_t n, std::size_t grain, Threads threads, const F& f) {
#if defined(GRAZE_HAVE_TBB)
  if (threads == Threads::all && n > grain) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain), [&](const auto& range) { f(range.begin(), range.end()); });
    return;
  }
#endif
  static_cast<void>(grain);
  static_cast<void>(threads);
  if (n != 0) f(std::size_t(0), n);
}

/// The sum of what part(begin, end) gives for parts of [0, n), on all cores where it is long; in the order of the parts.
template <class Sum, class Part, class Add>
[[nodiscard]] Sum summed(std::size_t n, Threads threads, const Part& part, const Add& add) {
  constexpr std::size_t parts = 8, least = 1 << 14;
  if (n < least) return part(std::size_t(0), n);
  std::array<Sum, parts> sums;
  for_ranges(parts, 1, threads, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) sums[i] = part(n * i / parts, n * (i + 1) / parts);
  });
  for (std::size_t i = 1; i < parts; ++i) add(sums[0], sums[i]);
  return sums[0];
}

}  // namespace graze::scene
