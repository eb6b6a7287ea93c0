// The floor under the hot loops: what their operations and bytes take at the machine's own peaks, measured in the same run.
#pragma once

#include "bench/json_out.hpp"

namespace graze::bench {

/// Peaks (operations and bytes a ns), and for each loop its operations and bytes a query, its rounds and its floor in ns.
[[nodiscard]] nlohmann::json floor_of_loops(const Plan& plan);

}  // namespace graze::bench
