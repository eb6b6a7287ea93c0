#include "fuzz/certify/campaign.hpp"

#include <algorithm>

#include "fuzz/certify/mesh_rays.hpp"
#include "fuzz/certify/parallel.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t cases_a_job = 2048, cases_asked_at_once = 256;

struct Job {
  std::size_t row;
  std::function<void(Row&)> work;
};

template <Real T>
void judge_family(const Family& family, std::uint64_t seed, std::uint64_t from, std::uint64_t to, const Judges& judges,
                  Progress& progress, Tally& tally) {
  std::vector<Case<T>> inputs;
  std::vector<Reply<T>> replies;
  for (std::uint64_t index = from; index < to && !progress.is_stopped(); index += inputs.size()) {
    inputs.clear();
    for (std::uint64_t i = index; i < std::min(index + cases_asked_at_once, to); ++i) {
      inputs.push_back(make<T>(family, seed, i).input);
    }
    replies.assign(inputs.size(), {});
    judges.subject.answer(std::span<const Case<T>>(inputs), std::span(replies));
    for (std::size_t i = 0; i < inputs.size(); ++i) check(judges, inputs[i], replies[i], index + i, tally);
    progress.cases_done += inputs.size();
  }
}

template <Real T>
void plan_family(const Family& family, const Campaign& campaign, const Judges& judges, Progress& progress,
                 std::vector<Row>& rows, std::vector<Job>& jobs) {
  const std::size_t row = rows.size();
  rows.push_back({std::string(family.name), precision_name<T>, {}});
  for (std::uint64_t from = 0; from < campaign.cases; from += cases_a_job) {
    const std::uint64_t to = std::min(from + cases_a_job, campaign.cases);
    jobs.push_back({row, [&family, &judges, &progress, seed = campaign.seed, from, to](Row& part) {
                      judge_family<T>(family, seed, from, to, judges, progress, part.tally);
                    }});
  }
  progress.cases_planned += campaign.cases;
}

template <Real T>
void plan_mesh(const Mesh& mesh, const Campaign& campaign, const Judges& judges, Progress& progress, std::vector<Row>& rows,
               std::vector<Job>& jobs) {
  const auto rays = std::make_shared<const MeshRays<T>>(mesh, campaign.seed);
  for (const Target target : {Target::corner, Target::edge_midpoint, Target::face_center}) {
    const std::size_t row = rows.size(), count = rays->count(target);
    rows.push_back({mesh.name + ": " + std::string(name_of(target)), precision_name<T>, {}, true});
    if (count == 0) rows.back().obstacle = "no point inside the mesh was found in 64 draws";
    for (std::size_t from = 0; from < count; from += cases_a_job) {
      const std::size_t to = std::min<std::size_t>(from + cases_a_job, count);
      jobs.push_back({row, [rays, &judges, &progress, target, from, to](Row& part) {
                        for (std::size_t i = from; i < to && !progress.is_stopped(); ++i) {
                          judge_mesh_ray(*rays, target, i, judges, part);
                          ++progress.cases_done;
                        }
                      }});
    }
    progress.cases_planned += count;
  }
}

}  // namespace

std::vector<Row> run(const Campaign& campaign, const Judges& judges, Progress& progress) {
  std::vector<Row> rows;
  std::vector<Job> jobs;
  for (const Family* family : campaign.families) {
    plan_family<float>(*family, campaign, judges, progress, rows, jobs);
    plan_family<double>(*family, campaign, judges, progress, rows, jobs);
  }
  for (const Mesh& mesh : campaign.meshes) {
    if (progress.is_stopped()) break;
    plan_mesh<float>(mesh, campaign, judges, progress, rows, jobs);
    plan_mesh<double>(mesh, campaign, judges, progress, rows, jobs);
  }
  // Parts are merged in the order of the jobs, whoever ran them when.
  std::vector<Row> parts(jobs.size());
  for_each_job(jobs.size(), [&](std::size_t i) { jobs[i].work(parts[i]); });
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    Row& row = rows[jobs[i].row];
    row.tally.merge(parts[i].tally);
    row.rays += parts[i].rays;
    row.lost_rays += parts[i].lost_rays;
  }
  return rows;
}

}  // namespace graze::fuzz
