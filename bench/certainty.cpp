#include "bench/certainty.hpp"

#include <algorithm>
#include <cstdio>

#include "bench/certainty_mix.hpp"
#include "bench/sphere_entries.hpp"
#include "bench/triangle_entries.hpp"

namespace graze::bench {
namespace {

template <class Query>
nlohmann::json times_of(const std::vector<Entry<Query>>& entries, const std::vector<Query>& queries, const Plan& plan) {
  constexpr std::string_view wanted[] = {"graze-hits", "graze-intersect", "cgal-epick-hits", "moller-trumbore",
                                         "textbook-naive"};
  std::vector<Contest> contests;
  std::vector<const Entry<Query>*> chosen;
  for (const Entry<Query>& entry : entries) {
    if (std::find(std::begin(wanted), std::end(wanted), entry.name) == std::end(wanted)) continue;
    // All queries, of the slow ones the first few: a stride would change the shares.
    const std::span<const Query> asked = std::span(queries).first(queries.size() / entry.stride);
    contests.push_back({entry.name, entry.prepare(asked), asked.size()});
    chosen.push_back(&entry);
  }
  const std::vector<std::vector<double>> rounds = measure(contests, plan.effort);
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    list.push_back(
        {{"name", chosen[i]->name}, {"label", chosen[i]->label}, {"ours", chosen[i]->is_ours}, {"rounds", rounds[i]}});
  }
  return list;
}

template <class Query>
void measure_shares(const char* shape, const std::vector<Entry<Query>>& entries, const Plan& plan, nlohmann::json& out) {
  for (const int percent : degenerate_percents) {
    std::fprintf(stderr, "cost of certainty: %s, %d %%\n", shape, percent);
    const std::vector<Query> queries = certainty_mix(Query{}, plan.timed_queries, percent, plan.seed);
    out.push_back(
        {{"shape", shape}, {"mix", "degenerate"}, {"percent", percent}, {"entries", times_of(entries, queries, plan)}});
  }
}

}  // namespace

nlohmann::json cost_of_certainty(const Plan& plan) {
  nlohmann::json out = nlohmann::json::array();
  const auto triangles = triangle_entries<double>();
  measure_shares("triangle", triangles, plan, out);
  const auto ties = tie_triangles(plan.timed_queries, plan.seed);
  out.push_back({{"shape", "triangle"}, {"mix", "ties"}, {"entries", times_of(triangles, ties, plan)}});
  measure_shares("sphere", sphere_entries<double>(), plan, out);
  return out;
}

}  // namespace graze::bench
