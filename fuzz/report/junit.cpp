#include "fuzz/report/junit.hpp"

#include <algorithm>

#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

std::string property(const char* name, const std::string& value) {
  return std::string("    <property name=\"") + name + "\" value=\"" + escaped(value) + "\"/>\n";
}

std::string offenders(const Report& report, const Tally& tally) {
  std::string text;
  for (const Offender& o : tally.offenders) {
    text += std::string(name_of(o.comparison.disagreement)) + ", case " + std::to_string(o.index) + "\nanswers  " + o.answer +
            "\nexact    " + o.truth + "\n" + replay_command(report, o) + "\n\n";
  }
  return text;
}

/// Judged to its end, as far as this report is to hold it.
bool is_finished(const Report& report, const Row& row) {
  if (report.shards.empty()) return row.is_whole();
  return std::all_of(report.shards.begin(), report.shards.end(),
                     [&](const Shard& s) { return row.gaps(s.of(row.planned)).empty(); });
}

}  // namespace

std::string junit(const Report& report) {
  std::size_t failures = 0, errors = 0, skipped = 0;
  std::string cases;
  for (const Row& row : report.rows) {
    const Part part = row.total();
    const Tally& t = part.tally;
    cases += "    <testcase classname=\"" + escaped("graze.certify." + report.scope.kernel + "." + row.precision) +
             "\" name=\"" + escaped(row.name) + "\">";
    if (!part.is_clean()) {
      ++failures;
      cases += "<failure message=\"" +
               escaped(grouped(t.answers - t.count(Disagreement::none)) + " of " + grouped(t.answers) + " answers are wrong, " +
                       grouped(part.lost_rays) + " rays are lost") +
               "\">" + escaped(offenders(report, t)) + "</failure>";
    } else if (!row.obstacle.empty() || !is_finished(report, row)) {
      ++errors;
      cases += "<error message=\"" + escaped(row.obstacle.empty() ? "interrupted" : row.obstacle) + "\"/>";
    } else if (t.answers == 0) {
      ++skipped;
      cases += "<skipped message=\"no query that the kernel offers\"/>";
    }
    cases += "</testcase>\n";
  }
  std::string float_modes;
  for (const FloatMode mode : report.scope.modes) float_modes.append(float_modes.empty() ? "" : ",").append(word_of(mode));
  const std::string counts =
      formatted("tests=\"%zu\" failures=\"%zu\" errors=\"%zu\" skipped=\"%zu\"", report.rows.size(), failures, errors, skipped);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts + ">\n  <testsuite name=\"" +
         escaped("graze certify " + report.scope.kernel) + "\" " + counts + ">\n    <properties>\n" +
         property("version", report.scope.version) + property("seed", std::to_string(report.scope.seed)) +
         property("cases_per_row", std::to_string(report.scope.cases)) + property("float_modes", float_modes) +
         "    </properties>\n" + cases + "  </testsuite>\n</testsuites>\n";
}

}  // namespace graze::fuzz
