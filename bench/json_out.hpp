// Results as JSON, and where they come from.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/effort.hpp"
#include "bench/errors.hpp"

namespace graze::bench {

/// JSON has no infinity: as a word, as Python's float() reads it.
[[nodiscard]] inline nlohmann::json number(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x < 0 ? "-inf" : "inf";
}

[[nodiscard]] inline nlohmann::json to_json(const Errors& e) {
  nlohmann::json out{{"queries", e.queries}, {"hits", e.hits}, {"wrong", e.wrong}, {"values", e.values}};
  if (e.values == 0) return out;
  out["correct"] = e.correct;
  out["median_ulps"] = number(e.median);
  out["p999_ulps"] = number(e.p999);
  out["max_ulps"] = number(e.max);
  out["worst_case"] = e.worst_case;
  return out;
}

/// The machine, the compiler, its flags, the date, the plan.
[[nodiscard]] nlohmann::json provenance(const Plan& plan);

}  // namespace graze::bench
