// Errors and wrong kinds along the sweeps, and the worst cases that a hunt finds.
#pragma once

#include "bench/json_out.hpp"

namespace graze::bench {

/// A list of sweeps, each with a line a kernel and a point a level.
[[nodiscard]] nlohmann::json stability(const Plan& plan);

}  // namespace graze::bench
