// Conditions that rays and spheres get worse by, from benign to hopeless.
#pragma once

#include "bench/sweep.hpp"

namespace graze::bench {

[[nodiscard]] std::vector<Sweep<fuzz::RaySphere<double>>> sphere_sweeps();

}  // namespace graze::bench
