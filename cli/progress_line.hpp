// A line on a terminal, kept up to date while a campaign runs.
#pragma once

#include <thread>

#include "fuzz/certify/campaign.hpp"

namespace graze::cli {

/// On standard error while it lives, and only where that is a terminal: cases, rate, time left, discrepancies.
class ProgressLine {
 public:
  explicit ProgressLine(const fuzz::Progress& progress);

 private:
  std::jthread thread_;
};

}  // namespace graze::cli
