// JSON back to a report.
#include <charconv>
#include <limits>
#include <stdexcept>

#include "fuzz/report/json.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

double number(const Json& json) {
  return json == "inf" ? std::numeric_limits<double>::infinity() : json.get<double>();
}

std::uint64_t hash_of(const Json& json) {
  const auto text = json.get<std::string>();
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (error != std::errc() || end != text.data() + text.size()) throw std::invalid_argument("'" + text + "' is no hash");
  return hash;
}

/// The disagreement of that name.
Disagreement disagreement_of(const std::string& name) {
  for (std::size_t i = 0; i < disagreement_count; ++i) {
    if (name_of(static_cast<Disagreement>(i)) == name) return static_cast<Disagreement>(i);
  }
  throw std::invalid_argument("'" + name + "' is no disagreement");
}

FloatMode mode_of(const Json& json) {
  const auto mode = find_float_mode(json.get<std::string>());
  if (!mode) throw std::invalid_argument(json.dump() + " is no floating-point mode");
  return *mode;
}

Offender offender_of(const Json& json) {
  Offender offender;
  offender.comparison.disagreement = disagreement_of(json.at("disagreement"));
  offender.comparison.error_ulps = number(json.at("error_ulps"));
  json.at("case").get_to(offender.index);
  json.at("precision").get_to(offender.precision);
  offender.mode = mode_of(json.at("float_mode"));
  json.at("input").get_to(offender.input);
  json.at("answer").get_to(offender.answer);
  json.at("exact").get_to(offender.truth);
  return offender;
}

Part part_of(const Json& json, Range range) {
  Part part;
  part.range = range;
  Tally& t = part.tally;
  json.at("answers").get_to(t.answers);
  json.at("not_offered").get_to(t.skipped);
  json.at("second_oracle_asked").get_to(t.oracles_compared);
  json.at("misrounded").get_to(t.misrounded);
  t.worst_ulps = number(json.at("worst_error_ulps"));
  for (const auto& [name, count] : json.at("disagreements").items()) {
    count.get_to(t.by_disagreement[static_cast<std::size_t>(disagreement_of(name))]);
  }
  for (const auto& [name, count] : json.at("allowed_deviations").items()) {
    const auto deviation = find_deviation(name);
    if (!deviation) throw std::invalid_argument("'" + name + "' is no deviation");
    count.get_to(t.by_deviation[static_cast<std::size_t>(*deviation)]);
  }
  for (const auto& [name, count] : json.at("errors_in_ulps").items()) {
    std::size_t bin = 0;
    while (bin < error_bins && error_bin_name(bin) != name) ++bin;
    if (bin == error_bins) throw std::invalid_argument("'" + name + "' is no size of an error");
    count.get_to(t.by_error[bin]);
  }
  for (const Json& offender : json.at("offenders")) t.offenders.push_back(offender_of(offender));
  part.rays = json.value("rays", std::uint64_t{0});
  part.lost_rays = json.value("lost_rays", std::uint64_t{0});
  part.input_hash = hash_of(json.at("input_hash"));
  return part;
}

Row row_of(const Json& json) {
  Row row;
  json.at("name").get_to(row.name);
  json.at("precision").get_to(row.precision);
  row.is_mesh = json.at("kind") == "mesh";
  json.at("planned").get_to(row.planned);
  row.obstacle = json.value("obstacle", std::string());
  if (!json.contains("parts")) {
    if (row.planned != 0) row.parts.push_back(part_of(json, {0, row.planned}));
    return row;
  }
  std::uint64_t end = 0;
  for (const Json& entry : json.at("parts")) {
    const Range range{entry.at("from"), entry.at("to")};
    if (range.from < end || range.from >= range.to || range.to > row.planned) {
      throw std::invalid_argument("row " + row.name + " has parts out of order");
    }
    end = range.to;
    row.parts.push_back(part_of(entry, range));
  }
  return row;
}

Scope scope_of(const Json& json) {
  Scope scope;
  json.at("version").get_to(scope.version);
  const Json& kernel = json.at("kernel");
  kernel.at("name").get_to(scope.kernel);
  kernel.at("about").get_to(scope.about);
  kernel.at("options").get_to(scope.options);
  for (const Json& name : kernel.at("declares")) {
    const auto deviation = find_deviation(name.get<std::string>());
    if (!deviation) throw std::invalid_argument(name.dump() + " is no deviation");
    // It follows from the limits, unless it was declared without any.
    scope.declared.set.add(*deviation);
  }
  scope.declared.t_ulps = number(kernel.at("t_ulps"));
  scope.declared.uv_ulps = number(kernel.at("uv_ulps"));
  const Json& about = json.at("scope");
  about.at("seed").get_to(scope.seed);
  about.at("cases_per_row").get_to(scope.cases);
  for (const Json& word : about.at("float_modes")) scope.modes.push_back(mode_of(word));
  if (scope.modes.empty()) throw std::invalid_argument("float_modes is empty");
  about.at("second_oracle_every").get_to(scope.second_oracle_every);
  for (const Json& mesh : about.at("meshes")) {
    scope.meshes.push_back({mesh.at("name"), mesh.at("triangles"), hash_of(mesh.at("hash"))});
  }
  about.at("compiler").get_to(scope.compiler);
  about.at("flags").get_to(scope.flags);
  return scope;
}

Report report_of(const Json& json) {
  Report report;
  report.scope = scope_of(json);
  json.at("scope").at("cpus").get_to(report.cpus);
  for (const Json& name : json.value("shards", Json::array())) {
    const auto shard = parse_shard(name.get<std::string>());
    if (!shard) throw std::invalid_argument(name.dump() + " is no shard");
    report.shards.insert(*shard);
  }
  for (const Json& row : json.at("rows")) report.rows.push_back(row_of(row));
  return report;
}

}  // namespace

std::variant<Report, ReportError> parse_report(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || json.value("format", Json()) != report_format) {
      return ReportError{"is no report of graze certify: its format is not \"" + std::string(report_format) + "\""};
    }
    Report report = report_of(json);
    if (const std::string difference = first_difference(json, to_json(report)); !difference.empty()) {
      return ReportError{"does not fit together; what it says and what follows from the rest: " + difference};
    }
    return report;
  } catch (const Json::parse_error& error) {
    return ReportError{"is not JSON to its end (byte " + std::to_string(error.byte) + ")"};
  } catch (const std::exception& error) {
    return ReportError{std::string("is no report of graze certify: ") + error.what()};
  }
}

}  // namespace graze::fuzz
