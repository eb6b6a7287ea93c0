// Work on all cores where oneTBB is there and the caller allows it.
#pragma once

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

}  // namespace graze::scene
