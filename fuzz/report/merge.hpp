// Reports of one campaign made one.
#pragma once

#include <string>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// Adds what `other` holds and `report` does not. Parts stay apart until their row is whole, so any order and grouping gives
/// the same report, and what is in both counts once: the same part must be the same in both; a part within a greater one must
/// fit into it. Returns what is wrong, a clause that names the field, or nothing; where something is wrong, `report` is as it
/// was.
[[nodiscard]] std::string merge(Report& report, const Report& other);

/// What the campaign lacks: shards by their names where the report knows any, else the ranges of the first row that has gaps.
/// Empty where the report is whole.
[[nodiscard]] std::string missing(const Report& report);

}  // namespace graze::fuzz
