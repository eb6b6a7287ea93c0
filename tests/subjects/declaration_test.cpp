// What a program declares.
#include "fuzz/plugins/declaration.hpp"

#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

Declaration read(std::string_view words) {
  const auto parsed = parse_declaration(words);
  CAPTURE(std::string(words));
  REQUIRE(std::holds_alternative<Declaration>(parsed));
  return std::get<Declaration>(parsed);
}

bool is_refused(std::string_view words) {
  return std::holds_alternative<LineError>(parse_declaration(words));
}

}  // namespace

TEST_CASE("nothing declared is everything offered and nothing allowed") {
  const Declaration d = read("");
  CHECK(d.offers_query(Case<float>(RaySphere<float>{})));
  CHECK(d.offers_query(Case<double>(PointSphere<double>{})));
  CHECK(d.deviations.set.empty());
  CHECK(d.deviations.t_ulps == 0.5);
}

TEST_CASE("queries and precisions that are named are the only ones") {
  const Declaration d = read("ray_triangle, point_line,float");
  CHECK(d.offers_query(Case<float>(RayTriangle<float>{})));
  CHECK(d.offers_query(Case<float>(PointLine<float>{})));
  CHECK(!d.offers_query(Case<float>(RaySphere<float>{})));
  CHECK(!d.offers_query(Case<double>(RayTriangle<double>{})));
}

TEST_CASE("deviations and limits by name") {
  const Declaration d = read("coplanar-is-miss,no-facing,t-ulps=4,uv-ulps=1e6");
  CHECK(d.deviations.set == DeviationSet{Deviation::coplanar_is_miss, Deviation::no_facing});
  CHECK(d.deviations.t_ulps == 4);
  CHECK(d.deviations.uv_ulps == 1e6);
  for (const DeviationText& text : deviation_texts) CHECK(is_refused(text.name) == (text.name == "inexact-numbers"));
}

TEST_CASE("what can't be declared") {
  CHECK(is_refused("sideways"));
  CHECK(is_refused("t-ulps=0.25"));
  CHECK(is_refused("t-ulps=nan"));
  CHECK(is_refused("uv-ulps="));
  CHECK(is_refused("no-facing,,no-root"));
}
