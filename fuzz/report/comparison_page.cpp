#include <algorithm>

#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"
#include "fuzz/report/page.hpp"
#include "fuzz/report/page_parts.hpp"
#include "fuzz/report/side_by_side.hpp"

namespace graze::fuzz {
namespace {

std::string summary(std::span<const Report> reports) {
  std::string body;
  for (const Report& report : reports) {
    const Part total = report.total();
    const Tally& t = total.tally;
    const auto count = [&](std::uint64_t n, std::uint64_t of) {
      const double share = of == 0 ? 0 : static_cast<double>(n) / static_cast<double>(of);
      return "<td" + heat(share) + ">" + grouped(n) + (n == 0 ? "" : element("small", percent(n, of))) + "</td>";
    };
    std::uint64_t allowed = 0;
    for (const std::uint64_t n : t.by_deviation) allowed += n;
    body += "<tr>" + element("th", report.scope.kernel, "class='name'") + "<td>" + verdict_badge(report.verdict()) +
            "</td><td>" + grouped(t.answers) + "</td>" + count(t.wrong_kinds(), t.answers) +
            count(t.count(Disagreement::lost_hit), t.answers) + count(t.count(Disagreement::false_hit), t.answers) +
            count(t.count(Disagreement::misrounded), t.answers) + element("td", worst_error(t)) +
            (total.rays == 0 ? "<td class='zero'>–</td>" : count(total.lost_rays, total.rays)) + "<td>" + grouped(allowed) +
            "</td></tr>\n";
  }
  return "<div class='wide'><table>\n<thead><tr><th class='name'>kernel</th><th>verdict</th><th>answers</th><th>wrong "
         "kinds</th><th>of these lost "
         "hits</th><th>false hits</th><th>numbers too far off</th><th>worst ulp</th><th>rays lost at meshes</th><th>declared, "
         "allowed</th></tr></thead>\n<tbody>\n" +
         body + "</tbody></table></div>\n";
}

std::string families(std::span<const Report> reports, const std::string& precision) {
  std::string body;
  const Report& first = reports.front();
  for (std::size_t i = 0; i < first.rows.size(); ++i) {
    if (first.rows[i].precision != precision) continue;
    body += "<tr>" + element("th", first.rows[i].name, "class='name'");
    for (const Report& report : reports) {
      const Part part = report.rows[i].total();
      const Tally& t = part.tally;
      if (t.answers == 0) {
        body += "<td class='zero'>–</td>";
        continue;
      }
      const std::uint64_t wrong = t.wrong_kinds() + t.count(Disagreement::failed);
      body += "<td" + heat(static_cast<double>(wrong) / static_cast<double>(t.answers)) + ">" + percent(wrong, t.answers) +
              element("small", short_error(t)) + "</td>";
    }
    body += "</tr>\n";
  }
  std::string head = "<th class='name'>" + precision + "</th>";
  for (const Report& report : reports) head += element("th", report.scope.kernel);
  return "<div class='wide'><table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + body +
         "</tbody></table></div>\n<p></p>\n";
}

std::string kernels(std::span<const Report> reports) {
  std::string markup = "<h2>The kernels</h2>\n<dl>\n";
  for (const Report& report : reports) {
    std::string declared;
    for (const Deviation d : declared_deviations(report.scope.declared)) {
      declared.append(declared.empty() ? " Declares: " : "; ").append(deviation_texts[static_cast<std::size_t>(d)].means);
    }
    markup += element("dt", report.scope.kernel) +
              element("dd", report.scope.about + "." + declared + (declared.empty() ? "" : ".")) + "\n";
  }
  return markup + "</dl>\n";
}

/// The worst case of every kernel.
std::string offenders(std::span<const Report> reports) {
  std::string markup;
  for (const Report& report : reports) {
    const Row* worst = nullptr;
    Offender offender;
    for (const Row& row : report.rows) {
      const Tally t = row.total().tally;
      if (t.offenders.empty()) continue;
      const Comparison &found = t.offenders.front().comparison, &kept = offender.comparison;
      if (worst != nullptr && (found.disagreement != kept.disagreement ? found.disagreement < kept.disagreement
                                                                       : found.error_ulps <= kept.error_ulps)) {
        continue;
      }
      worst = &row;
      offender = t.offenders.front();
    }
    if (worst != nullptr) markup += element("h3", report.scope.kernel) + offender_section(report, *worst, offender);
  }
  return markup.empty() ? markup : "<h2>The worst case of each</h2>\n" + markup;
}

}  // namespace

std::string comparison_page(std::span<const Report> reports) {
  const Report& first = reports.front();
  return document(
      "graze certify: " + std::to_string(reports.size()) + " kernels",
      "<h1>" + std::to_string(reports.size()) + " kernels on the same boundary cases</h1>\n" +
          element("p",
                  "graze certify --compare, seed " + std::to_string(first.scope.seed) + ", " + grouped(first.scope.cases) +
                      " cases a family and precision. The families are made to be hard; “random” is what programs mostly meet. "
                      "What a "
                      "kernel declares is allowed for.",
                  "class='soft'") +
          "\n" + summary(reports) +
          "<h2>Wrong decisions, family by family</h2>\n<p class='soft'>The share of answers with a wrong decision of any "
          "sort; below it the worst error of a number in ulps. –: the kernel offers no query of the family.</p>\n" +
          families(reports, "double") + families(reports, "float") + offenders(reports) + kernels(reports) +
          scope_section(first) + family_notes(first),
      Width::broad);
}

}  // namespace graze::fuzz
