// What certainty costs: ns a query against the share of degenerate input.
#pragma once

#include "bench/json_out.hpp"

namespace graze::bench {

/// A list of groups: shape, percent, and rounds of this library's queries and of two peers.
[[nodiscard]] nlohmann::json cost_of_certainty(const Plan& plan);

}  // namespace graze::bench
