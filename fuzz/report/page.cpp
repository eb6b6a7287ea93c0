#include "fuzz/report/page.hpp"

#include <algorithm>
#include <vector>

#include "fuzz/report/histogram.hpp"
#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"
#include "fuzz/report/page_parts.hpp"
#include "fuzz/report/side_by_side.hpp"

namespace graze::fuzz {
namespace {

constexpr std::size_t shown_offenders = 12;

std::string fact(const std::string& value, const char* name) {
  return "<div>" + element("b", value) + element("span", name, "class='soft'") + "</div>\n";
}

std::string headline(const Report& report) {
  const Part total = report.total();
  const Tally& t = total.tally;
  std::string markup = "<h1>" + verdict_badge(report.verdict()) + " " + escaped(report.scope.kernel) + "</h1>\n" +
                       element("p", report.scope.about, "class='soft'") + "\n<div class='facts'>\n" +
                       fact(grouped(t.answers), "answers") + fact(grouped(t.wrong_kinds()), "wrong kinds") +
                       fact(grouped(t.count(Disagreement::misrounded)), "numbers too far off") +
                       fact(worst_error(t), "ulps, the worst error");
  if (total.rays != 0) markup += fact(grouped(total.lost_rays) + " of " + grouped(total.rays), "rays lost at meshes");
  if (const auto n = t.count(Disagreement::failed); n != 0) markup += fact(grouped(n), "cases without an answer");
  markup += "</div>\n";
  if (!report.is_finished()) markup += "<p>The run was interrupted: what is not told here is not known.</p>\n";
  if (const auto n = t.count(Disagreement::oracles); n != 0) {
    markup += element("p", "The two oracles differ on " + grouped(n) + " cases: the certifier itself is wrong there.");
  }
  if (total.is_clean() && t.answers != 0) {
    markup += element("p", "Nothing is wrong in " + grouped(t.answers) + " answers to n = " + grouped(report.cases_of(t)) +
                               " cases. By the rule of three, of cases drawn like these less than 3/n = " +
                               formatted("%.2g", 3 / static_cast<double>(report.cases_of(t))) +
                               " are answered wrongly, with 95 % confidence; the table has it family by family.");
  }
  return markup;
}

/// The disagreements that a table has columns for: those that occur; and the names of the others.
struct Columns {
  std::vector<Disagreement> shown;
  std::string absent;
};

Columns columns_of(const Report& report) {
  Columns columns;
  const Tally total = report.total().tally;
  for (std::size_t i = disagreement_count - 1; i > 0; --i) {
    const auto d = static_cast<Disagreement>(i);
    if (total.count(d) != 0) {
      columns.shown.push_back(d);
    } else {
      columns.absent.append(columns.absent.empty() ? "" : ", ").append(name_of(d));
    }
  }
  return columns;
}

std::string count_cell(std::uint64_t count, std::uint64_t of) {
  if (count == 0) return "<td class='zero'>0</td>";
  const double share = of == 0 ? 0 : static_cast<double>(count) / static_cast<double>(of);
  return "<td" + heat(share) + ">" + grouped(count) + "</td>";
}

/// One of families, or one of meshes.
std::string table(const Report& report, const Columns& columns, bool of_meshes) {
  std::string body;
  bool has_allowed = false;
  for (const Row& row : report.rows) {
    const Tally t = row.total().tally;
    has_allowed = has_allowed || std::any_of(t.by_deviation.begin(), t.by_deviation.end(), [](auto n) { return n != 0; });
  }
  for (const Row& row : report.rows) {
    const Part part = row.total();
    const Tally& t = part.tally;
    if (row.is_mesh != of_meshes || (t.answers == 0 && row.obstacle.empty())) continue;
    body += "<tr>" + element("th", row.name, "class='name'") + element("td", row.precision);
    if (!row.obstacle.empty()) {
      body += "<td colspan='16' class='name'>" + escaped(row.obstacle) + "</td></tr>\n";
      continue;
    }
    const std::uint64_t wrong = t.answers - t.count(Disagreement::none);
    body += element("td", part.is_clean() ? rate_bound(report.cases_of(t)) : percent(wrong, t.answers));
    if (of_meshes) body += "<td>" + grouped(part.rays) + "</td>" + count_cell(part.lost_rays, part.rays);
    body += "<td>" + grouped(t.answers) + "</td>";
    for (const Disagreement d : columns.shown) body += count_cell(t.count(d), t.answers);
    body += element("td", worst_error(t));
    if (has_allowed) {
      std::uint64_t allowed = 0;
      for (const std::uint64_t n : t.by_deviation) allowed += n;
      body += "<td>" + grouped(allowed) + "</td>";
    }
    body += "</tr>\n";
  }
  if (body.empty()) return body;
  std::string head = std::string("<th class='name'>") + (of_meshes ? "mesh: aimed at" : "family") +
                     "</th><th>precision</th><th>wrong answers</th>";
  if (of_meshes) head += "<th>rays</th><th>lost rays</th>";
  head += "<th>answers</th>";
  for (const Disagreement d : columns.shown) head += element("th", name_of(d));
  head += "<th>worst ulp</th>";
  if (has_allowed) head += "<th>allowed</th>";
  return std::string(of_meshes ? "<h2>Rays at meshes</h2>\n" : "<h2>Families</h2>\n") +
         "<div class='wide'><table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

std::string tables(const Report& report) {
  const Columns columns = columns_of(report);
  std::string markup = table(report, columns, false) + table(report, columns, true);
  if (!columns.absent.empty()) markup += element("p", "In no row: " + columns.absent + ".", "class='soft'");
  return markup +
         "<p class='soft'>A share with “&lt;” is a bound: nothing wrong in n cases means below 3/n with 95 % confidence.</p>\n";
}

std::string deviations(const Report& report) {
  const Deviations& declared = report.scope.declared;
  const auto all = declared_deviations(declared);
  if (all.empty()) return {};
  const Tally total = report.total().tally;
  std::string markup =
      "<h2>Declared by the kernel</h2>\n<p>Allowed for, and not counted as wrong.</p>\n<div class='wide'><table "
      "class='loose'><tbody>\n";
  for (const Deviation d : all) {
    std::string means(deviation_texts[static_cast<std::size_t>(d)].means);
    if (d == Deviation::inexact_numbers)
      means += formatted(": t within %g ulps, u and v within %g", declared.t_ulps, declared.uv_ulps);
    markup += "<tr>" + element("th", means, "class='name'") + "<td>" + grouped(total.count(d)) + "</td></tr>\n";
  }
  return markup + "</tbody></table></div>\n";
}

std::string histograms(const Report& report) {
  std::string markup;
  for (const char* precision : {"float", "double"}) {
    Tally sum;
    for (const Row& row : report.rows) {
      if (row.precision == precision) sum.merge(row.total().tally);
    }
    const std::string chart = error_histogram(sum);
    if (!chart.empty()) markup += element("h3", precision) + "<div class='wide'>" + chart + "</div>\n";
  }
  if (markup.empty()) return markup;
  return "<h2>Errors in ulps</h2>\n<p class='soft'>Answers of the right kind, by the error of their worst number; a bar from "
         "2^k to "
         "2^(k+1). “≤½” are those all of whose numbers are correctly rounded. Both scales are logarithmic.</p>\n" +
         markup;
}

/// The worst of each row, the worst rows first.
std::string offenders(const Report& report) {
  std::vector<std::pair<Offender, const Row*>> worst;
  std::size_t kept = 0;
  for (const Row& row : report.rows) {
    const Tally t = row.total().tally;
    kept += t.offenders.size();
    if (!t.offenders.empty()) worst.emplace_back(t.offenders.front(), &row);
  }
  if (worst.empty()) return {};
  std::stable_sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) {
    const Comparison &x = a.first.comparison, &y = b.first.comparison;
    return x.disagreement != y.disagreement ? x.disagreement > y.disagreement : x.error_ulps > y.error_ulps;
  });
  std::string markup = "<h2>The worst offenders</h2>\n";
  const std::size_t shown = std::min(worst.size(), shown_offenders);
  for (std::size_t i = 0; i < shown; ++i) markup += offender_section(report, *worst[i].second, worst[i].first);
  return markup + element("p",
                          "The worst of " + grouped(shown) + " rows out of " + grouped(worst.size()) +
                              " that have any; the JSON report has " + grouped(kept) + ", up to " +
                              grouped(Tally::kept_offenders) + " a row.",
                          "class='soft'");
}

}  // namespace

std::string page(const Report& report) {
  return document("graze certify: " + report.scope.kernel, headline(report) + deviations(report) + tables(report) +
                                                               histograms(report) + offenders(report) + scope_section(report) +
                                                               family_notes(report));
}

}  // namespace graze::fuzz
