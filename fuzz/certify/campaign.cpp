#include "fuzz/certify/campaign.hpp"

#include <algorithm>
#include <memory>

#include "fuzz/certify/input_hash.hpp"
#include "fuzz/certify/mesh_rays.hpp"
#include "fuzz/certify/parallel.hpp"

namespace graze::fuzz {
namespace {

/// A unit of work: long enough that its bookkeeping does not show, short enough that a core is never long without.
constexpr std::uint64_t cases_a_unit = 1024;
/// The subject is asked as many cases at once; a stop is heeded between.
constexpr std::uint64_t cases_at_once = 256;

/// Cases of a row that are to be judged, as units numbered on from `first_unit`.
struct Work {
  std::size_t row;
  Range range;
  std::size_t first_unit;
};

std::uint64_t discrepancies(const Part& part) {
  return part.tally.answers - part.tally.count(Disagreement::none) + part.tally.count(Disagreement::oracles) + part.lost_rays;
}

}  // namespace

template <Real T>
void Plan::plan_family(const Family& family, const Campaign& campaign) {
  rows_.push_back({std::string(family.name), precision_name<T>, false, campaign.cases});
  judges_.push_back([&family, seed = campaign.seed](Range cases, const Judges& judges, Part& part) {
    std::vector<Case<T>> inputs;
    for (std::uint64_t i = cases.from; i < cases.to; ++i) inputs.push_back(make<T>(family, seed, i).input);
    const Replies<T> replies = ask(judges, inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      part.input_hash += input_hash(inputs[i], cases.from + i);
      check(judges, inputs[i], replies, i, cases.from + i, part.tally);
    }
  });
}

template <Real T>
void Plan::plan_mesh(const Mesh& mesh, std::uint64_t seed) {
  const auto rays = std::make_shared<const MeshRays<T>>(mesh, seed);
  for (const Target target : targets) {
    rows_.push_back({mesh.name + ": " + std::string(name_of(target)), precision_name<T>, true, rays->count(target)});
    if (rays->count(target) == 0) rows_.back().obstacle = "no point inside the mesh was found in 64 draws";
    judges_.push_back(
        [rays, target](Range cases, const Judges& judges, Part& part) { judge_mesh_rays(*rays, target, cases, judges, part); });
  }
}

Campaign default_campaign() {
  Campaign campaign;
  for (const Family& family : families()) campaign.families.push_back(&family);
  campaign.meshes = {icosphere(4), wavy_sphere(4)};
  return campaign;
}

Plan::Plan(const Campaign& campaign) {
  for (const Family* family : campaign.families) {
    plan_family<float>(*family, campaign);
    plan_family<double>(*family, campaign);
  }
  for (const Mesh& mesh : campaign.meshes) {
    plan_mesh<float>(mesh, campaign.seed);
    plan_mesh<double>(mesh, campaign.seed);
  }
}

void run(const Plan& plan, const Judges& judges, const Shard& shard, Ledger& ledger, Progress& progress) {
  std::vector<Work> works;
  std::size_t units = 0;
  const std::vector<Row> rows = ledger.rows();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const Range gap : rows[row].gaps(shard.of(rows[row].planned))) {
      works.push_back({row, gap, units});
      units += (gap.to - gap.from + cases_a_unit - 1) / cases_a_unit;
      progress.cases_planned += gap.to - gap.from;
    }
  }
  for_each_job(units, [&](std::size_t unit) {
    if (progress.is_stopped()) return;
    const auto after = std::upper_bound(works.begin(), works.end(), unit,
                                        [](std::size_t wanted, const Work& work) { return wanted < work.first_unit; });
    const Work& work = *std::prev(after);
    const std::uint64_t from = work.range.from + (unit - work.first_unit) * cases_a_unit;
    const std::uint64_t to = std::min(from + cases_a_unit, work.range.to);
    Part part{{from, from}, {}};
    while (part.range.to < to && !progress.is_stopped()) {
      const Range next{part.range.to, std::min(part.range.to + cases_at_once, to)};
      plan.judge(work.row, next, judges, part);
      progress.cases_done += next.to - next.from;
    }
    progress.discrepancies += discrepancies(part);
    ledger.cover(work.row, std::move(part));
  });
}

}  // namespace graze::fuzz
