#include "fuzz/report/json.hpp"

#include <limits>

#include "fuzz/certify/input_hash.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

/// JSON has no infinity.
Json number(double x) {
  return x == std::numeric_limits<double>::infinity() ? Json("inf") : Json(x);
}

Json hash_text(std::uint64_t hash) {
  return formatted("%016llx", static_cast<unsigned long long>(hash));
}

Json offender_json(const Report& report, const Offender& o) {
  return {{"case", o.index},
          {"precision", o.precision},
          {"float_mode", word_of(o.mode)},
          {"disagreement", name_of(o.comparison.disagreement)},
          {"error_ulps", number(o.comparison.error_ulps)},
          {"input", o.input},
          {"answer", o.answer},
          {"exact", o.truth},
          {"replay", replay_command(report, o)}};
}

/// Of a row, whose tally is that of its one part, or of many.
Json row_json(const Report& report, const Row& row) {
  std::uint64_t judged = 0;
  for (const Part& part : row.parts) judged += part.range.to - part.range.from;
  Json json{{"name", row.name},
            {"precision", row.precision},
            {"kind", row.is_mesh ? "mesh" : "family"},
            {"planned", row.planned},
            {"judged", judged}};
  if (!row.obstacle.empty()) json["obstacle"] = row.obstacle;
  json.update(to_json(report, row.total(), row.is_mesh));
  const bool is_one = row.planned == 0 || (row.parts.size() == 1 && row.parts[0].range == Range{0, row.planned});
  if (is_one) return json;
  json["parts"] = Json::array();
  for (const Part& part : row.parts) {
    Json entry{{"from", part.range.from}, {"to", part.range.to}};
    entry.update(to_json(report, part, row.is_mesh));
    json["parts"].push_back(std::move(entry));
  }
  return json;
}

Json totals_json(const Report& report) {
  // Hashes of rows would cancel in a sum where two rows change places.
  WordHash hash;
  for (const Row& row : report.rows) hash.add(row.total().input_hash);
  Part total = report.total();
  total.input_hash = hash.value();
  Json json = to_json(report, total, true);
  json.erase("offenders");
  return json;
}

}  // namespace

Json to_json(const Report& report, const Part& part, bool is_mesh) {
  const Tally& t = part.tally;
  Json disagreements = Json::object(), deviations = Json::object(), errors = Json::object(), offenders = Json::array();
  for (std::size_t i = 0; i < disagreement_count; ++i) {
    disagreements[std::string(name_of(static_cast<Disagreement>(i)))] = t.by_disagreement[i];
  }
  for (std::size_t i = 0; i < deviation_count; ++i) {
    if (t.by_deviation[i] != 0) deviations[std::string(name_of(static_cast<Deviation>(i)))] = t.by_deviation[i];
  }
  for (std::size_t i = 0; i < error_bins; ++i) {
    if (t.by_error[i] != 0) errors[error_bin_name(i)] = t.by_error[i];
  }
  for (const Offender& o : t.offenders) offenders.push_back(offender_json(report, o));
  Json json{{"answers", t.answers},
            {"not_offered", t.skipped},
            {"second_oracle_asked", t.oracles_compared},
            {"wrong_kinds", t.wrong_kinds()},
            {"misrounded", t.misrounded},
            {"worst_error_ulps", number(t.worst_ulps)},
            {"disagreements", std::move(disagreements)},
            {"allowed_deviations", std::move(deviations)},
            {"errors_in_ulps", std::move(errors)}};
  if (is_mesh) {
    json["rays"] = part.rays;
    json["lost_rays"] = part.lost_rays;
  }
  json["input_hash"] = hash_text(part.input_hash);
  json["offenders"] = std::move(offenders);
  return json;
}

Json identity(const Report& report) {
  const Scope& s = report.scope;
  Json declared = Json::array(), modes = Json::array(), meshes = Json::array(), rows = Json::array();
  for (const Deviation d : declared_deviations(s.declared)) declared.push_back(name_of(d));
  for (const FloatMode mode : s.modes) modes.push_back(word_of(mode));
  for (const MeshIdentity& mesh : s.meshes) {
    meshes.push_back({{"name", mesh.name}, {"triangles", mesh.triangles}, {"hash", hash_text(mesh.hash)}});
  }
  for (const Row& row : report.rows) {
    rows.push_back({{"name", row.name},
                    {"precision", row.precision},
                    {"kind", row.is_mesh ? "mesh" : "family"},
                    {"planned", row.planned},
                    {"obstacle", row.obstacle}});
  }
  return {{"version", s.version},
          {"kernel",
           {{"name", s.kernel},
            {"about", s.about},
            {"options", s.options},
            {"declares", std::move(declared)},
            {"t_ulps", number(s.declared.t_ulps)},
            {"uv_ulps", number(s.declared.uv_ulps)}}},
          {"scope",
           {{"seed", s.seed},
            {"cases_per_row", s.cases},
            {"float_modes", std::move(modes)},
            {"second_oracle_every", s.second_oracle_every},
            {"meshes", std::move(meshes)},
            {"compiler", s.compiler},
            {"flags", s.flags}}},
          {"rows", std::move(rows)}};
}

Json to_json(const Report& report) {
  const Json same = identity(report);
  Json json{{"format", report_format},       {"version", same.at("version")}, {"verdict", name_of(report.verdict())},
            {"complete", report.is_whole()}, {"kernel", same.at("kernel")},   {"scope", same.at("scope")}};
  json["scope"]["cpus"] = report.cpus;
  if (!report.shards.empty()) {
    json["shards"] = Json::array();
    for (const Shard& shard : report.shards) json["shards"].push_back(text_of(shard));
  }
  json["totals"] = totals_json(report);
  json["rows"] = Json::array();
  for (const Row& row : report.rows) json["rows"].push_back(row_json(report, row));
  return json;
}

std::string first_difference(const Json& a, const Json& b) {
  const Json changes = Json::diff(a, b);
  if (changes.empty()) return {};
  const Json::json_pointer place(changes[0].at("path").get<std::string>());
  const auto value = [&](const Json& in) {
    const std::string text = in.contains(place) ? in.at(place).dump() : "missing";
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
  };
  return place.to_string().substr(1) + ": " + value(a) + " and " + value(b);
}

}  // namespace graze::fuzz
