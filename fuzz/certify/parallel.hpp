// Jobs on all cores by oneTBB, or one after the other where it is not installed.
#pragma once

#include <cstddef>

#if GRAZE_HAVE_TBB
#include <oneapi/tbb/parallel_for.h>
#endif

namespace graze::fuzz {

/// job(i) for every i < n, in any order.
template <class Job>
void for_each_job(std::size_t n, const Job& job) {
#if GRAZE_HAVE_TBB
  tbb::parallel_for(std::size_t{0}, n, job);
#else
  for (std::size_t i = 0; i < n; ++i) job(i);
#endif
}

}  // namespace graze::fuzz
