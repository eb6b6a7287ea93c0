// A line on a terminal, kept up to date while a campaign runs.
#pragma once

#include <string_view>
#include <thread>

#include "fuzz/certify/campaign.hpp"

namespace graze::cli {

/// On standard error while it lives, and only where that is a terminal: how many, rate, time left, discrepancies.
class ProgressLine {
 public:
  /// `what` is done: a plural.
  explicit ProgressLine(const fuzz::Progress& progress, std::string_view what = "cases");

 private:
  std::jthread thread_;
};

}  // namespace graze::cli
