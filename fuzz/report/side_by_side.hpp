// Several kernels on the same campaign, for people at a terminal.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// "12.3 %"; never "0.0 %" or "100.0 %" where it is not.
[[nodiscard]] std::string percent(std::uint64_t n, std::uint64_t of);

/// The worst error in ulps, to two digits.
[[nodiscard]] std::string short_error(const Tally& tally);

/// A line a kernel, then families against kernels. The reports are of one campaign.
void print_side_by_side(std::span<const Report> reports, std::ostream& out);

}  // namespace graze::fuzz
