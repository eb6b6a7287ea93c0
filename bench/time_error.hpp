// Time against error: every entry on every mix.
#pragma once

#include "bench/json_out.hpp"

namespace graze::bench {

/// A list of groups: shape, mix, format and its entries with rounds (ns a query, each repetition's) and errors.
[[nodiscard]] nlohmann::json time_against_error(const Plan& plan);

}  // namespace graze::bench
