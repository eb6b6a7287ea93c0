// Conditions that rays and triangles get worse by, from benign to hopeless.
#pragma once

#include "bench/sweep.hpp"

namespace graze::bench {

[[nodiscard]] std::vector<Sweep<fuzz::RayTriangle<double>>> triangle_sweeps();

}  // namespace graze::bench
