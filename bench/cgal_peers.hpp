// CGAL's exact predicates as contenders: EPICK and EPECK do_intersect, on inputs converted to CGAL's types beforehand.
#pragma once

#include <vector>

#include "bench/mixes.hpp"
#include "bench/timing.hpp"

namespace graze::bench {

void add_cgal_peers(std::vector<Contender>& contenders, const TriangleMix<double>& mix);
void add_cgal_peers(std::vector<Contender>& contenders, const SphereMix<double>& mix);

}  // namespace graze::bench
