// Reports read back, and what is refused.
#include "fuzz/report/json.hpp"
#include "fuzz/report/merge.hpp"
#include "tests/campaign/generated.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

std::string refusal(const std::string& text) {
  const auto read = parse_report(text);
  REQUIRE(std::holds_alternative<ReportError>(read));
  return std::get<ReportError>(read).what;
}

TEST_CASE("what is written reads back to the same bytes") {
  for (std::uint64_t count = 1; count <= 4; ++count) {
    for (const std::uint64_t done : {std::uint64_t{0}, std::uint64_t{3}, ~std::uint64_t{0}}) {
      const std::string text = to_json(of_shard({count, count}, done)).dump(2);
      const auto read = parse_report(text);
      REQUIRE(std::holds_alternative<Report>(read));
      REQUIRE(to_json(std::get<Report>(read)).dump(2) == text);
    }
  }
}

TEST_CASE("an infinite error is told as such") {
  Report report = of_shard({1, 1});
  report.rows[0].parts[0].tally.worst_ulps = 1.0 / 0.0;
  CHECK(to_json(report).at("rows").at(0).at("worst_error_ulps") == "inf");
  CHECK(to_json(report).dump().find("null") == std::string::npos);
}

TEST_CASE("what is no report is refused") {
  const std::string text = to_json(of_shard({1, 2})).dump();
  CHECK(refusal("").starts_with("is not JSON"));
  CHECK(refusal(text.substr(0, text.size() / 2)).starts_with("is not JSON"));
  CHECK(refusal("[]").starts_with("is no report of graze certify"));
  CHECK(refusal("{}").starts_with("is no report of graze certify"));
  CHECK(refusal(R"({"format": "graze report 2"})").starts_with("is no report of graze certify"));
}

TEST_CASE("a field that is missing, of another type or unfit is named") {
  const auto refused = [](const std::string& place, const Json& value, const std::string& names) {
    Json json = to_json(of_shard({1, 2}));
    json[Json::json_pointer(place)] = value;
    const std::string what = refusal(json.dump());
    INFO(what);
    CHECK(what.find(names) != std::string::npos);
  };
  refused("/scope/seed", "one", "/scope/seed");
  refused("/rows/0/parts/0/disagreements/agreed", 1, "'agreed' is no disagreement");
  refused("/rows/0/parts/0/errors_in_ulps/many", 1, "'many' is no size");
  refused("/rows/0/parts/0/allowed_deviations/all", 1, "'all' is no deviation");
  refused("/rows/0/parts/0/input_hash", "xyz", "'xyz' is no hash");
  refused("/scope/float_modes/0", "sideways", "\"sideways\" is no floating-point mode");
  refused("/scope/float_modes", Json::array(), "float_modes is empty");
  refused("/rows/0/parts/0/to", 41, "row first has parts out of order");
  refused("/rows/0/parts/0/to", 0, "row first has parts out of order");
  refused("/shards/0", "3/2", "\"3/2\" is no shard");
  refused("/rows/0/wrong_kinds", 1000, "rows/0/wrong_kinds: 1000 and ");
  refused("/verdict", "pass", "verdict: \"pass\" and \"fail\"");
  refused("/extra", 1, "extra: 1 and missing");

  Json json = to_json(of_shard({1, 2}));
  json["rows"][0].erase("planned");
  CHECK(refusal(json.dump()).find("'planned' not found") != std::string::npos);
}

}  // namespace
}  // namespace graze::fuzz
