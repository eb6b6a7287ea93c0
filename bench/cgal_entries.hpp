// CGAL's kernels as entries: EPICK (exact predicates, inexact constructions) and EPECK (both exact, lazily). Compiled by
// itself: what CGAL asks of the compiler (-frounding-math) would slow everybody else.
#pragma once

#include <vector>

#include "bench/entry.hpp"

namespace graze::bench {

void add_cgal_entries(std::vector<Entry<fuzz::RayTriangle<double>>>& entries);
void add_cgal_entries(std::vector<Entry<fuzz::RaySphere<double>>>& entries);

}  // namespace graze::bench
