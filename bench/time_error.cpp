#include "bench/time_error.hpp"

#include <algorithm>
#include <cstdio>

#include "bench/mixes.hpp"
#include "bench/sphere_entries.hpp"
#include "bench/triangle_entries.hpp"

namespace graze::bench {
namespace {

template <class Query>
std::vector<Query> every(std::span<const Query> queries, std::size_t stride) {
  std::vector<Query> out;
  for (std::size_t i = 0; i < queries.size(); i += stride) out.push_back(queries[i]);
  return out;
}

template <class Query>
Errors judged(const Entry<Query>& entry, std::span<const Query> queries, std::span<const TruthOf<Query>> truths) {
  // Slow ones: fewer.
  const std::size_t n = entry.stride > 16 ? queries.size() / 4 : queries.size();
  queries = queries.first(n);
  truths = truths.first(n);
  if (entry.answers) {
    const std::vector<HitOf<Query>> answers = entry.answers(queries);
    return errors_of<Query>(queries, truths, answers, entry.deviations);
  }
  return errors_of<Query>(queries, truths, entry.decisions(queries), entry.deviations);
}

template <class Query>
void measure_mixes(const char* shape, const char* format, const std::vector<Entry<Query>>& entries, const Plan& plan,
                   nlohmann::json& out) {
  for (const Mix<Query>& mix : mixes_of(Query{})) {
    std::fprintf(stderr, "time against error: %s, %s, %.*s\n", shape, format, int(mix.name.size()), mix.name.data());
    const std::vector<Query> queries = mix.make(plan.timed_queries, plan.seed);
    std::vector<std::vector<Query>> inputs;
    std::vector<Contest> contests;
    for (const Entry<Query>& entry : entries) inputs.push_back(every<Query>(queries, entry.stride));
    for (std::size_t i = 0; i < entries.size(); ++i) {
      contests.push_back({entries[i].name, entries[i].prepare(inputs[i]), inputs[i].size()});
    }
    const std::vector<std::vector<double>> rounds = measure(contests, plan.effort);
    const std::vector<Query> asked(queries.begin(), queries.begin() + static_cast<std::ptrdiff_t>(plan.judged_queries));
    const std::vector<TruthOf<Query>> truths = truths_of<Query>(asked);
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const Entry<Query>& e = entries[i];
      list.push_back({{"name", e.name},
                      {"label", e.label},
                      {"about", e.about},
                      {"task", e.answers ? "numbers" : "decision"},
                      {"ours", e.is_ours},
                      {"queries", contests[i].queries},
                      {"rounds", rounds[i]},
                      {"errors", to_json(judged<Query>(e, asked, truths))}});
    }
    out.push_back({{"shape", shape}, {"format", format}, {"mix", mix.name}, {"title", mix.title}, {"entries", list}});
  }
}

}  // namespace

nlohmann::json time_against_error(const Plan& plan) {
  nlohmann::json out = nlohmann::json::array();
  measure_mixes("triangle", "double", triangle_entries<double>(), plan, out);
  measure_mixes("triangle", "float", triangle_entries<float>(), plan, out);
  measure_mixes("sphere", "double", sphere_entries<double>(), plan, out);
  measure_mixes("sphere", "float", sphere_entries<float>(), plan, out);
  return out;
}

}  // namespace graze::bench
