#include "fuzz/report/page_parts.hpp"

#include <algorithm>
#include <set>

#include "fuzz/report/drawing.hpp"
#include "fuzz/report/json.hpp"
#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"
#include "fuzz/report/style.hpp"

namespace graze::fuzz {
namespace {

std::string fact(const char* name, const std::string& value) {
  return element("dt", name) + element("dd", value) + "\n";
}

}  // namespace

std::string document(const std::string& title, const std::string& body, Width width) {
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         element("title", title) + "\n<link rel=\"icon\" href=\"data:,\">\n<style>" + std::string(page_style) +
         "</style>\n</head>\n<body" + (width == Width::broad ? " class=\"broad\"" : "") + ">\n" + body + "</body>\n</html>\n";
}

std::string verdict_badge(Verdict verdict) {
  const char* const sign = verdict == Verdict::pass ? "✓ PASS" : verdict == Verdict::fail ? "✗ FAIL" : "… INCOMPLETE";
  return element("span", sign, "class='verdict " + std::string(name_of(verdict)) + "'");
}

std::string scope_section(const Report& report) {
  const Scope& s = report.scope;
  const auto joined = [](const auto& names) {
    std::string text;
    for (const auto& name : names) text.append(text.empty() ? "" : ", ").append(name);
    return text;
  };
  std::set<std::string> precisions;
  for (const Row& row : report.rows) precisions.insert(row.precision);
  std::vector<std::string> meshes, shards;
  for (const MeshIdentity& mesh : s.meshes) meshes.push_back(mesh.name + " (" + grouped(mesh.triangles) + " triangles)");
  for (const Shard& shard : report.shards) shards.push_back(text_of(shard));
  std::string markup = "<h2>Scope</h2>\n<dl>\n" + fact("graze", s.version) + fact("seed", std::to_string(s.seed)) +
                       fact("cases a family and precision", grouped(s.cases)) + fact("precisions", joined(precisions));
  if (!meshes.empty()) markup += fact("meshes", joined(meshes));
  if (!shards.empty()) markup += fact("shards of the campaign", joined(shards));
  const std::string modes = modes_told(s);
  markup += fact("floating-point modes", modes.empty() ? "the default one" : modes);
  markup += fact("second oracle",
                 s.second_oracle_every == 0 ? "not asked" : "confirms every " + grouped(s.second_oracle_every) + "th case") +
            fact("compiler", s.compiler) + fact("flags", s.flags) + fact("processor", joined(report.cpus)) +
            fact("hash of all inputs", to_json(report).at("totals").at("input_hash").get<std::string>());
  return markup + "</dl>\n";
}

std::string family_notes(const Report& report) {
  std::string markup, last;
  for (const Row& row : report.rows) {
    const Family* family = row.is_mesh ? nullptr : find_family(row.name);
    if (family == nullptr || last == row.name) continue;
    last = row.name;
    const Note& note = family->note;
    markup += element("dt", row.name) + "<dd>" + escaped(family->attacks) +
              element("p",
                      "The bug: " + std::string(note.bug) + ". What is seen of it: " + std::string(note.effect) +
                          ". Published: " + std::string(note.published) + ".",
                      "class='soft'") +
              "</dd>\n";
  }
  return markup.empty() ? markup : "<h2>What the families attack</h2>\n<dl>\n" + markup + "</dl>\n";
}

std::string offender_section(const Report& report, const Row& row, const Offender& o) {
  std::string title(name_of(o.comparison.disagreement));
  if (o.comparison.error_ulps > 0) title += formatted(", %.4g ulps off", o.comparison.error_ulps);
  return "<section class='offender'>\n<div>" + drawing(o) + "</div>\n<div>" + element("h3", title) +
         element("p",
                 row.name + ", " + o.precision + ", case " + grouped(o.index) +
                     (o.mode == FloatMode::nearest ? "" : ", " + std::string(name_of(o.mode))),
                 "class='soft'") +
         "\n<dl>" + fact("answers", o.answer) + fact("exact", o.truth) + "</dl>\n" + element("pre", o.input) +
         "\n<details><summary>Replay</summary>" + element("pre", replay_command(report, o)) + "</details></div>\n</section>\n";
}

std::string heat(double share) {
  return share > 0 ? formatted(" style='background:rgba(var(--heat),%.2f)'", 0.08 + 0.42 * std::min(share, 1.0))
                   : std::string();
}

std::string rate_bound(std::uint64_t n) {
  return n == 0 ? "–" : formatted("< %.2g %%", std::min(100.0, 300 / static_cast<double>(n)));
}

}  // namespace graze::fuzz
