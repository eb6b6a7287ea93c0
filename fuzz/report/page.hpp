// A report as one page: no other file, no network, no script.
#pragma once

#include <span>
#include <string>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// Verdict, scope, families against disagreements, errors as a picture, the worst offenders with their geometry.
[[nodiscard]] std::string page(const Report& report);

/// Several kernels on the same campaign, side by side.
[[nodiscard]] std::string comparison_page(std::span<const Report> reports);

}  // namespace graze::fuzz
