// A report as JUnit XML, for continuous integration.
#pragma once

#include <string>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// A test case a row: passed; failed, with the worst offenders; skipped, where the kernel offers no query of the row; an error,
/// where it was not judged to its end or could not be.
[[nodiscard]] std::string junit(const Report& report);

}  // namespace graze::fuzz
