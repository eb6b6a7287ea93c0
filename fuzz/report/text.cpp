#include "fuzz/report/text.hpp"

#include <algorithm>
#include <cctype>

#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

constexpr std::size_t printed_offenders = 12;

/// A mesh of which there is something to tell: a kernel without triangles has no rays there.
bool is_mesh(const Row& row) {
  return row.is_mesh && (row.total().rays != 0 || !row.obstacle.empty());
}

std::string in_capitals(std::string_view word) {
  std::string text(word);
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

void print_verdict(const Report& report, std::optional<double> seconds, std::ostream& out) {
  const Part total = report.total();
  const Tally& tally = total.tally;
  out << in_capitals(name_of(report.verdict())) << "  " << report.scope.kernel << ": " << grouped(tally.answers) << " answers, "
      << grouped(tally.wrong_kinds()) << " wrong kinds, " << grouped(tally.misrounded)
      << " with a number not correctly rounded, worst error " << worst_error(tally) << " ulp";
  if (std::any_of(report.rows.begin(), report.rows.end(), is_mesh)) out << ", " << grouped(total.lost_rays) << " lost rays";
  if (const auto n = tally.count(Disagreement::failed); n != 0) out << ", " << grouped(n) << " cases without an answer";
  out << " (seed " << report.scope.seed;
  if (const std::string modes = modes_told(report.scope); !modes.empty()) out << ", " << modes;
  if (!report.shards.empty()) out << ", shard";
  for (const Shard& shard : report.shards) out << ' ' << text_of(shard);
  if (seconds) out << formatted(", %.1f s", *seconds);
  out << ')';
  if (!report.is_finished()) out << "; interrupted, the rest is not known";
  out << '\n';
  if (const auto n = tally.count(Disagreement::oracles); n != 0) {
    out << "The two oracles differ on " << grouped(n) << " cases: the certifier itself is wrong there.\n";
  }
}

void print_families(const Report& report, std::ostream& out) {
  out << formatted("\n%-22s %-9s %10s %12s %10s %10s %12s %11s\n", "family", "precision", "answers", "wrong kinds", "lost hits",
                   "false hits", "misrounded", "worst ulp");
  for (const Row& row : report.rows) {
    const Tally t = row.total().tally;
    if (row.is_mesh || t.answers == 0) continue;
    out << formatted("%-22s %-9s %10llu %12llu %10llu %10llu %12llu %11s\n", row.name.c_str(), row.precision.c_str(),
                     static_cast<unsigned long long>(t.answers), static_cast<unsigned long long>(t.wrong_kinds()),
                     static_cast<unsigned long long>(t.count(Disagreement::lost_hit)),
                     static_cast<unsigned long long>(t.count(Disagreement::false_hit)),
                     static_cast<unsigned long long>(t.misrounded), worst_error(t).c_str());
  }
}

void print_meshes(const Report& report, std::ostream& out) {
  if (std::none_of(report.rows.begin(), report.rows.end(), is_mesh)) return;
  out << formatted("\n%-34s %-9s %10s %10s %10s %12s %12s %11s\n", "mesh, rays from inside at its", "precision", "rays",
                   "lost rays", "answers", "wrong kinds", "misrounded", "worst ulp");
  for (const Row& row : report.rows) {
    if (!is_mesh(row)) continue;
    const Part total = row.total();
    const Tally& t = total.tally;
    if (!row.obstacle.empty()) {
      out << formatted("%-34s %-9s %s\n", row.name.c_str(), row.precision.c_str(), row.obstacle.c_str());
      continue;
    }
    out << formatted("%-34s %-9s %10llu %10llu %10llu %12llu %12llu %11s\n", row.name.c_str(), row.precision.c_str(),
                     static_cast<unsigned long long>(total.rays), static_cast<unsigned long long>(total.lost_rays),
                     static_cast<unsigned long long>(t.answers), static_cast<unsigned long long>(t.wrong_kinds()),
                     static_cast<unsigned long long>(t.misrounded), worst_error(t).c_str());
  }
}

/// What the subject declares, with how often it was allowed for.
void print_deviations(const Report& report, std::ostream& out) {
  const Deviations& declared = report.scope.declared;
  if (declared_deviations(declared).empty()) return;
  const Tally total = report.total().tally;
  out << "\nDeclared by the kernel, allowed for, and not counted as wrong:\n";
  for (const Deviation d : declared_deviations(declared)) {
    out << formatted("  %-22s %12llu  ", std::string(name_of(d)).c_str(), static_cast<unsigned long long>(total.count(d)))
        << deviation_texts[static_cast<std::size_t>(d)].means;
    if (d == Deviation::inexact_numbers) {
      out << formatted("; t within %g ulps, u and v within %g", declared.t_ulps, declared.uv_ulps);
    }
    out << '\n';
  }
}

/// Each row's worst, row by row, then what is left out.
void print_offenders(const Report& report, std::ostream& out) {
  std::size_t shown = 0, rows = 0;
  for (const Row& row : report.rows) {
    const Tally tally = row.total().tally;
    if (tally.offenders.empty()) continue;
    ++rows;
    if (shown == printed_offenders) continue;
    if (shown++ == 0) out << "\nThe worst of each row:\n";
    const Offender& o = tally.offenders.front();
    out << "\n  " << row.name << ", " << o.precision << ", case " << o.index << ": " << name_of(o.comparison.disagreement);
    if (o.mode != FloatMode::nearest) out << ", " << name_of(o.mode);
    if (o.comparison.error_ulps > 0) out << formatted(", %.4g ulp off", o.comparison.error_ulps);
    out << "\n    answers  " << o.answer << "\n    exact    " << o.truth << "\n    " << replay_command(report, o) << '\n';
  }
  if (rows > shown) out << "\n  and " << rows - shown << " more rows; --json FILE writes them all\n";
}

}  // namespace

void print(const Report& report, std::optional<double> seconds, std::ostream& out) {
  print_verdict(report, seconds, out);
  print_families(report, out);
  print_meshes(report, out);
  print_deviations(report, out);
  print_offenders(report, out);
}

}  // namespace graze::fuzz
