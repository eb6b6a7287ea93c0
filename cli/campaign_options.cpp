#include "cli/campaign_options.hpp"

#include <utility>
#include <variant>

#include "cli/positive.hpp"

namespace graze::cli {

void add_options(CLI::App& command, CampaignOptions& options) {
  command.add_option("--cases", options.cases, "cases a family and precision (default 10000)")->check(positive);
  command.add_option("--seed", options.seed, "of the families' streams (default 1)");
  command.add_option("--families", options.families, "only these, comma-separated (default all)")->delimiter(',');
  command.add_option("--mesh", options.meshes,
                     "closed meshes to aim at from inside (default: two generated ones, unless families are named)");
  command.add_option("--second-oracle-every", options.second_oracle_every,
                     "CGAL confirms every N-th case (default 16, 1 for all, 0 for none)");
}

std::string fill(fuzz::Campaign& campaign, const CampaignOptions& options) {
  campaign = fuzz::default_campaign();
  campaign.seed = options.seed;
  campaign.cases = options.cases;
  if (!options.families.empty()) campaign.families.clear();
  for (const std::string& name : options.families) {
    const fuzz::Family* family = fuzz::find_family(name);
    if (family == nullptr) {
      std::string names;
      for (const fuzz::Family& f : fuzz::families()) names.append(names.empty() ? "" : ", ").append(f.name);
      return "no family is named '" + name + "'; there are: " + names;
    }
    campaign.families.push_back(family);
  }
  // Families chosen by name alone run alone.
  if (!options.meshes.empty() || !options.families.empty()) campaign.meshes.clear();
  for (const std::string& file : options.meshes) {
    auto mesh = fuzz::read_mesh(file);
    if (const auto* error = std::get_if<fuzz::MeshError>(&mesh)) return error->what;
    campaign.meshes.push_back(std::get<fuzz::Mesh>(std::move(mesh)));
    const auto open = fuzz::open_edges(campaign.meshes.back());
    if (!open.empty()) {
      return file + ": is not closed: the edge from point " + std::to_string(open.front().from) + " to point " +
             std::to_string(open.front().to) + " has no reverse (" + std::to_string(open.size()) + " such edges)";
    }
  }
  return {};
}

}  // namespace graze::cli
