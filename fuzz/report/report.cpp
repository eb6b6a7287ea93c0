#include "fuzz/report/report.hpp"

#include <algorithm>
#include <fstream>

#include "fuzz/certify/input_hash.hpp"
#include "fuzz/shell_word.hpp"

namespace graze::fuzz {
namespace {

/// As Linux tells it.
std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "incomplete";
}

Part Report::total() const {
  Part sum;
  for (const Row& row : rows) sum.add(row.total());
  return sum;
}

bool Report::is_whole() const {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.is_whole(); });
}

bool Report::is_finished() const {
  if (shards.empty()) return is_whole();
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    return std::all_of(shards.begin(), shards.end(), [&](const Shard& s) { return row.gaps(s.of(row.planned)).empty(); });
  });
}

Verdict Report::verdict() const {
  if (!total().is_clean()) return Verdict::fail;
  const bool all_aimed = std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.obstacle.empty(); });
  return is_finished() && all_aimed ? Verdict::pass : Verdict::incomplete;
}

Report blank_report(const Campaign& campaign, const Plan& plan, const Judges& judges, const Shard& shard) {
  Report report;
  report.scope = {GRAZE_VERSION,
                  std::string(judges.subject.name()),
                  std::string(judges.subject.about()),
                  judges.subject.deviations(),
                  campaign.seed,
                  campaign.cases,
                  judges.second_oracle_every,
                  {},
                  GRAZE_COMPILER,
                  GRAZE_FLAGS};
  for (const Mesh& mesh : campaign.meshes) report.scope.meshes.push_back({mesh.name, mesh.triangles.size(), input_hash(mesh)});
  report.cpus.insert(cpu_name());
  if (shard.count > 1) report.shards.insert(shard);
  report.rows = plan.rows();
  return report;
}

std::string replay_command(const Report& report, const Offender& offender) {
  return "echo '" + offender.input + "' | graze answer --details --precision " + offender.precision + " --kernel " +
         shell_word(report.scope.kernel);
}

}  // namespace graze::fuzz
