// Which campaign the command line asks for.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/certify/campaign.hpp"

namespace graze::cli {

struct CampaignOptions {
  std::uint64_t cases = 10000;
  std::uint64_t seed = 1;
  std::uint64_t second_oracle_every = fuzz::default_second_oracle_every;
  std::vector<std::string> families, meshes;
};

void add_options(CLI::App& command, CampaignOptions& options);

/// Fills the campaign. Returns what is wrong with the options, a sentence, or nothing.
[[nodiscard]] std::string fill(fuzz::Campaign& campaign, const CampaignOptions& options);

}  // namespace graze::cli
