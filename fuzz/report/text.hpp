// A report for people at a terminal.
#pragma once

#include <optional>
#include <ostream>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// One verdict line, then the tables, then the worst offenders with the command that replays each. `seconds`: of the run, where
/// there was one.
void print(const Report& report, std::optional<double> seconds, std::ostream& out);

}  // namespace graze::fuzz
