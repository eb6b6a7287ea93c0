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
  const Subject& subject = *judges.subjects.front();
  report.scope = {GRAZE_VERSION,
                  std::string(subject.name()),
                  std::string(subject.about()),
                  std::string(subject.options()),
                  subject.deviations(),
                  campaign.seed,
                  campaign.cases,
                  judges.second_oracle_every,
                  {},
                  {},
                  GRAZE_COMPILER,
                  GRAZE_FLAGS};
  for (const Subject* one : judges.subjects) report.scope.modes.push_back(one->float_mode());
  for (const Mesh& mesh : campaign.meshes) report.scope.meshes.push_back({mesh.name, mesh.triangles.size(), input_hash(mesh)});
  report.cpus.insert(cpu_name());
  if (shard.count > 1) report.shards.insert(shard);
  report.rows = plan.rows();
  return report;
}

std::string modes_told(const Scope& scope) {
  if (scope.modes == std::vector{FloatMode::nearest}) return {};
  if (scope.modes.size() == float_modes.size()) return "all " + std::to_string(float_modes.size()) + " floating-point modes";
  std::string told;
  for (const FloatMode mode : scope.modes) told.append(told.empty() ? "" : ", ").append(name_of(mode));
  return told;
}

std::string replay_command(const Report& report, const Offender& offender) {
  const Scope& s = report.scope;
  std::string command = "echo '" + offender.input + "' | graze answer --details --precision " + offender.precision;
  if (offender.mode != FloatMode::nearest) command.append(" --float-mode ").append(word_of(offender.mode));
  command += " --kernel " + shell_word(s.kernel);
  return s.options.empty() ? command : command + " " + s.options;
}

}  // namespace graze::fuzz
