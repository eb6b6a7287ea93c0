#include "cli/certify_report.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace graze::cli {
namespace {

using fuzz::Disagreement;
using fuzz::Offender;
using fuzz::Row;
using fuzz::Tally;

constexpr std::size_t printed_offenders = 12;

template <class... Args>
std::string formatted(const char* format, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

/// A correctly rounded number errs by at most half a unit; the exact error of a misrounded one is known.
std::string worst_error(const Tally& tally) {
  return tally.misrounded == 0 ? "<= 0.5" : formatted("%.4g", tally.worst_ulps);
}

/// A mesh of which there is something to tell: a kernel without triangles has no rays there.
bool is_mesh(const Row& row) {
  return row.is_mesh && (row.rays != 0 || !row.obstacle.empty());
}

void print_verdict(const CertifyReport& report, std::ostream& out) {
  const Tally total = report.total();
  const bool is_wrong = !total.is_clean() || report.lost_rays() != 0;
  out << (is_wrong               ? "FAIL"
          : report.is_complete() ? "PASS"
                                 : "INCOMPLETE")
      << "  " << report.kernel << ": " << grouped(total.cases) << " answers, " << grouped(total.wrong_kinds())
      << " wrong kinds, " << grouped(total.misrounded) << " with a number not correctly rounded, worst error "
      << worst_error(total) << " ulp";
  if (std::any_of(report.rows.begin(), report.rows.end(), is_mesh)) out << ", " << grouped(report.lost_rays()) << " lost rays";
  if (const auto n = total.count(Disagreement::failed); n != 0) out << ", " << grouped(n) << " cases without an answer";
  out << formatted(" (seed %llu, %.1f s)", static_cast<unsigned long long>(report.seed), report.seconds);
  if (report.is_interrupted) out << "; interrupted, the rest is not known";
  out << '\n';
  if (const auto n = total.count(Disagreement::oracles); n != 0) {
    out << "The two oracles differ on " << grouped(n) << " cases: the certifier itself is wrong there.\n";
  }
}

void print_families(const CertifyReport& report, std::ostream& out) {
  out << formatted("\n%-22s %-9s %10s %12s %10s %10s %12s %11s\n", "family", "precision", "cases", "wrong kinds", "lost hits",
                   "false hits", "misrounded", "worst ulp");
  for (const Row& row : report.rows) {
    if (row.is_mesh || row.tally.cases == 0) continue;
    const Tally& t = row.tally;
    out << formatted("%-22s %-9s %10llu %12llu %10llu %10llu %12llu %11s\n", row.name.c_str(), row.precision.c_str(),
                     static_cast<unsigned long long>(t.cases), static_cast<unsigned long long>(t.wrong_kinds()),
                     static_cast<unsigned long long>(t.count(Disagreement::lost_hit)),
                     static_cast<unsigned long long>(t.count(Disagreement::false_hit)),
                     static_cast<unsigned long long>(t.misrounded), worst_error(t).c_str());
  }
}

void print_meshes(const CertifyReport& report, std::ostream& out) {
  if (std::none_of(report.rows.begin(), report.rows.end(), is_mesh)) return;
  out << formatted("\n%-34s %-9s %10s %10s %10s %12s %12s %11s\n", "mesh, rays from inside at its", "precision", "rays",
                   "lost rays", "answers", "wrong kinds", "misrounded", "worst ulp");
  for (const Row& row : report.rows) {
    if (!is_mesh(row)) continue;
    const Tally& t = row.tally;
    if (!row.obstacle.empty()) {
      out << formatted("%-34s %-9s %s\n", row.name.c_str(), row.precision.c_str(), row.obstacle.c_str());
      continue;
    }
    out << formatted("%-34s %-9s %10llu %10llu %10llu %12llu %12llu %11s\n", row.name.c_str(), row.precision.c_str(),
                     static_cast<unsigned long long>(row.rays), static_cast<unsigned long long>(row.lost_rays),
                     static_cast<unsigned long long>(t.cases), static_cast<unsigned long long>(t.wrong_kinds()),
                     static_cast<unsigned long long>(t.misrounded), worst_error(t).c_str());
  }
}

/// What the subject declares, with how often it was allowed for.
void print_deviations(const CertifyReport& report, std::ostream& out) {
  const fuzz::Deviations& declared = report.deviations;
  if (fuzz::declared_deviations(declared).empty()) return;
  const Tally total = report.total();
  out << "\nDeclared by the kernel, allowed for, and not counted as wrong:\n";
  for (const fuzz::Deviation d : fuzz::declared_deviations(declared)) {
    out << formatted("  %-22s %12llu  ", std::string(name_of(d)).c_str(), static_cast<unsigned long long>(total.count(d)))
        << fuzz::deviation_texts[static_cast<std::size_t>(d)].means;
    if (d == fuzz::Deviation::inexact_numbers) {
      out << formatted("; t within %g ulps, u and v within %g", declared.t_ulps, declared.uv_ulps);
    }
    out << '\n';
  }
}

std::string replay(const CertifyReport& report, const Offender& offender) {
  return "echo '" + offender.input + "' | graze answer --details --precision " + offender.precision + " --kernel " +
         report.kernel;
}

/// Each row's worst, row by row, then what is left out.
void print_offenders(const CertifyReport& report, std::ostream& out) {
  std::size_t shown = 0, rows = 0;
  for (const Row& row : report.rows) {
    if (row.tally.offenders.empty()) continue;
    ++rows;
    if (shown == printed_offenders) continue;
    if (shown++ == 0) out << "\nThe worst of each row:\n";
    const Offender& o = row.tally.offenders.front();
    out << "\n  " << row.name << ", " << o.precision << ", case " << o.index << ": "
        << fuzz::name_of(o.comparison.disagreement);
    if (o.comparison.error_ulps > 0) out << formatted(", %.4g ulp off", o.comparison.error_ulps);
    out << "\n    answers  " << o.answer << "\n    exact    " << o.truth << "\n    " << replay(report, o) << '\n';
  }
  if (rows > shown) out << "\n  and " << rows - shown << " more rows; --json FILE writes them all\n";
}

nlohmann::json to_json(const CertifyReport& report, const Offender& o) {
  return {{"case", o.index},
          {"disagreement", fuzz::name_of(o.comparison.disagreement)},
          {"error_ulps", o.comparison.error_ulps},
          {"input", o.input},
          {"answer", o.answer},
          {"exact", o.truth},
          {"replay", replay(report, o)}};
}

}  // namespace

Tally CertifyReport::total() const {
  Tally total;
  for (const Row& row : rows) total.merge(row.tally);
  return total;
}

std::uint64_t CertifyReport::lost_rays() const {
  std::uint64_t n = 0;
  for (const Row& row : rows) n += row.lost_rays;
  return n;
}

bool CertifyReport::is_complete() const {
  return !is_interrupted && std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.obstacle.empty(); });
}

bool CertifyReport::is_clean() const {
  return is_complete() && total().is_clean() && lost_rays() == 0;
}

void print(const CertifyReport& report, std::ostream& out) {
  print_verdict(report, out);
  print_families(report, out);
  print_meshes(report, out);
  print_deviations(report, out);
  print_offenders(report, out);
}

nlohmann::json to_json(const CertifyReport& report) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Row& row : report.rows) {
    const Tally& t = row.tally;
    nlohmann::json by;
    for (std::size_t i = 0; i < t.by_disagreement.size(); ++i) {
      by[std::string(fuzz::name_of(static_cast<Disagreement>(i)))] = t.by_disagreement[i];
    }
    nlohmann::json offenders = nlohmann::json::array();
    for (const Offender& o : t.offenders) offenders.push_back(to_json(report, o));
    nlohmann::json entry{{"name", row.name},
                         {"precision", row.precision},
                         {"cases", t.cases},
                         {"not_offered", t.skipped},
                         {"wrong_kinds", t.wrong_kinds()},
                         {"misrounded", t.misrounded},
                         {"worst_error_ulps", t.worst_ulps},
                         {"confirmed_by_second_oracle", t.oracles_compared},
                         {"by_disagreement", by},
                         {"offenders", offenders}};
    if (row.is_mesh) {
      entry["rays"] = row.rays;
      entry["lost_rays"] = row.lost_rays;
      if (!row.obstacle.empty()) entry["obstacle"] = row.obstacle;
    }
    rows.push_back(std::move(entry));
  }
  const Tally total = report.total();
  nlohmann::json deviations = nlohmann::json::object();
  for (const fuzz::Deviation d : fuzz::declared_deviations(report.deviations)) {
    deviations[std::string(name_of(d))] = total.count(d);
  }
  return {{"tool", "graze certify"},
          {"version", GRAZE_VERSION},
          {"kernel", report.kernel},
          {"about", report.about},
          {"seed", report.seed},
          {"cases_per_family", report.cases},
          {"second_oracle_every", report.second_oracle_every},
          {"complete", report.is_complete()},
          {"clean", report.is_clean()},
          {"seconds", report.seconds},
          {"answers", total.cases},
          {"wrong_kinds", total.wrong_kinds()},
          {"misrounded", total.misrounded},
          {"worst_error_ulps", total.worst_ulps},
          {"lost_rays", report.lost_rays()},
          {"without_answer", total.count(Disagreement::failed)},
          {"deviations", deviations},
          {"t_ulps", report.deviations.t_ulps},
          {"uv_ulps", report.deviations.uv_ulps},
          {"rows", rows}};
}

}  // namespace graze::cli
