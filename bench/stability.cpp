#include "bench/stability.hpp"

#include <algorithm>
#include <cstdio>

#include "bench/sphere_entries.hpp"
#include "bench/sphere_sweeps.hpp"
#include "bench/triangle_entries.hpp"
#include "bench/triangle_sweeps.hpp"
#include "fuzz/case_text.hpp"

namespace graze::bench {
namespace {

/// A numeric error worse than any other that was seen, and where.
template <class Query>
struct Worst {
  double ulps = -1;
  Draws draws;
  Query query;
};

template <class Query>
Query made(const Sweep<Query>& sweep, int level, Draws draws) {
  draws.rewind();
  return sweep.make(level, draws);
}

template <class Query>
double error_of(const Entry<Query>& entry, const Query& query, const TruthOf<Query>& truth) {
  const Judgment j = judge(query, entry.answers(std::span(&query, 1)).front(), truth, entry.deviations);
  return j.is_wrong ? -1 : j.worst();
}

/// Never downhill from the worst case that is known, by changes of the numbers that it was made of: the condition is kept.
template <class Query>
void climb(const Entry<Query>& entry, const Sweep<Query>& sweep, int level, int steps, fuzz::Random random,
           Worst<Query>& worst) {
  for (int step = 0; step < steps; ++step) {
    Draws draws = worst.draws;
    for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes) draws.change(random);
    const Query query = made(sweep, level, draws);
    const double ulps = error_of(entry, query, truths_of<Query>(std::span(&query, 1)).front());
    if (ulps < worst.ulps) continue;
    worst = {ulps, draws, query};
  }
}

template <class Query>
nlohmann::json point(const Entry<Query>& entry, const Sweep<Query>& sweep, int level, const std::vector<Draws>& draws,
                     std::span<const Query> queries, std::span<const TruthOf<Query>> truths, const Plan& plan,
                     const fuzz::Random& random) {
  Worst<Query> worst{-1, draws.front(), queries.front()};
  std::vector<double> errors;
  std::size_t wrong = 0;
  const std::vector<HitOf<Query>> answers = entry.answers(queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Judgment j = judge(queries[i], answers[i], truths[i], entry.deviations);
    wrong += j.is_wrong ? 1 : 0;
    const double ulps = j.worst();
    if (j.is_wrong || ulps < 0) continue;
    errors.push_back(ulps);
    if (ulps > worst.ulps) worst = {ulps, draws[i], queries[i]};
  }
  nlohmann::json out{{"level", level}, {"wrong", wrong}, {"values", errors.size()}};
  if (errors.empty()) return out;
  out["median_ulps"] = number(quantile(errors, 0.5));
  out["max_ulps"] = number(worst.ulps);
  climb(entry, sweep, level, entry.stride > 16 ? plan.climb_steps / 4 : plan.climb_steps, random, worst);
  out["hunted_ulps"] = number(worst.ulps);
  out["worst_case"] = fuzz::format_case(fuzz::Case<double>(worst.query));
  return out;
}

template <class Query>
nlohmann::json lines(const Sweep<Query>& sweep, const std::vector<Entry<Query>>& entries, const Plan& plan) {
  std::fprintf(stderr, "stability: %.*s\n", int(sweep.name.size()), sweep.name.data());
  std::vector<nlohmann::json> lines;
  for (const Entry<Query>& entry : entries)
    lines.push_back({{"name", entry.name}, {"label", entry.label}, {"ours", entry.is_ours}});
  for (int level = sweep.first; level <= sweep.last; level += sweep.step * plan.level_step) {
    const fuzz::Random stream(plan.seed, sweep.name, static_cast<std::uint64_t>(level + 1024) << 32);
    std::vector<Draws> draws;
    std::vector<Query> queries;
    for (std::size_t i = 0; i < plan.level_queries; ++i) {
      fuzz::Random random = stream.at((static_cast<std::uint64_t>(level + 1024) << 32) + i);
      draws.emplace_back(random);
      queries.push_back(sweep.make(level, draws.back()));
    }
    const std::vector<TruthOf<Query>> truths = truths_of<Query>(queries);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      lines[i]["points"].push_back(
          point<Query>(entries[i], sweep, level, draws, queries, truths, plan, stream.at(static_cast<std::uint64_t>(i) + 1)));
    }
  }
  return {{"name", sweep.name},     {"title", sweep.title},          {"axis", sweep.axis}, {"slope", sweep.slope},
          {"theory", sweep.theory}, {"queries", plan.level_queries}, {"lines", lines}};
}

/// Those that tell numbers; batches answer what `intersect` does, bit for bit.
template <class Query>
std::vector<Entry<Query>> with_numbers(std::vector<Entry<Query>> entries) {
  std::erase_if(entries, [](const Entry<Query>& e) { return !e.answers || e.name == "graze-batch-intersect"; });
  return entries;
}

}  // namespace

nlohmann::json stability(const Plan& plan) {
  nlohmann::json out = nlohmann::json::array();
  const auto spheres = with_numbers(sphere_entries<double>());
  for (const auto& sweep : sphere_sweeps()) out.push_back(lines(sweep, spheres, plan));
  const auto triangles = with_numbers(triangle_entries<double>());
  for (const auto& sweep : triangle_sweeps()) out.push_back(lines(sweep, triangles, plan));
  return out;
}

}  // namespace graze::bench
