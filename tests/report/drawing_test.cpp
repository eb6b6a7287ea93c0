// Pictures of cases: of every family they can be drawn, stay within their frame, and show what is true.
#include "fuzz/report/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "fuzz/case_text.hpp"
#include "fuzz/family.hpp"
#include "fuzz/report/histogram.hpp"
#include "oracle/oracle.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
std::string drawn(const Case<T>& input) {
  return drawing({{}, 0, precision_name<T>, FloatMode::nearest, format_case(input), "", ""});
}

/// The numbers of the first attribute of that name after `from`: "x='1 2'" has two.
std::vector<double> numbers(const std::string& markup, const std::string& attribute, std::size_t from = 0) {
  const std::size_t start = markup.find(attribute + "='", from);
  if (start == std::string::npos) return {};
  std::string text = markup.substr(start + attribute.size() + 2);
  text.resize(text.find('\''));
  for (char& letter : text) {
    if (letter == 'M' || letter == 'L' || letter == 'Z') letter = ' ';
  }
  std::istringstream words(text);
  std::vector<double> all;
  for (double x; words >> x;) all.push_back(x);
  return all;
}

/// All coordinates lie in the frame of 240 by 170, arrows and marks a little out of it at most.
void require_framed(const std::string& markup) {
  for (const char* name : {" x", " y", " x1", " x2", " y1", " y2", " cx", " cy", " d"}) {
    for (std::size_t at = 0; (at = markup.find(std::string(name) + "='", at)) != std::string::npos; ++at) {
      const auto all = numbers(markup, name, at);
      REQUIRE_FALSE(all.empty());
      for (const double x : all) REQUIRE((x > -200 && x < 440));
    }
  }
  REQUIRE(markup.find("nan") == std::string::npos);
  REQUIRE(markup.find("='inf") == std::string::npos);
}

/// How far the mark of the crossing lies within the drawn triangle, as its least barycentric coordinate.
std::optional<double> depth_of_mark(const std::string& markup) {
  const std::size_t ring = markup.find("class='ring'");
  if (ring == std::string::npos) return std::nullopt;
  const double x = numbers(markup, "cx", ring).at(0), y = numbers(markup, "cy", ring).at(0);
  const std::vector<double> p = numbers(markup, " d");
  const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  };
  const double all = area(p[0], p[1], p[2], p[3], p[4], p[5]);
  return std::min({area(x, y, p[2], p[3], p[4], p[5]) / all, area(p[0], p[1], x, y, p[4], p[5]) / all,
                   area(p[0], p[1], p[2], p[3], x, y) / all});
}

struct Counts {
  int spheres = 0, triangles = 0, marks_within = 0;
};

template <Real T>
void check_case(const Case<T>& input, Counts& counts) {
  const std::string markup = drawn(input);
  INFO(format_case(input));
  INFO(markup);
  require_framed(markup);
  if (const auto* q = std::get_if<RaySphere<T>>(&input)) {
    if (markup.empty() || !(q->sphere.radius > 0)) return;
    ++counts.spheres;
    const SphereHit<T> truth = oracle::gmp_oracle().answer(q->ray, q->sphere);
    const double beside = std::abs(numbers(markup, "y1", markup.find("class='guide'")).at(0) - 85);
    const double radius = numbers(markup, " r").at(0);
    if (truth.kind == SphereKind::tangent) REQUIRE(std::abs(beside - radius) < 0.2);
    if (truth.kind == SphereKind::secant) REQUIRE(beside < radius + 0.2);
  } else if (const auto* t = std::get_if<RayTriangle<T>>(&input)) {
    if (markup.empty()) return;
    ++counts.triangles;
    const TriangleHit<T> truth = oracle::gmp_oracle().answer(t->ray, t->triangle);
    const auto depth = depth_of_mark(markup);
    if (!depth || truth.is_interval() || truth.kind == TriangleKind::invalid || truth.kind == TriangleKind::miss) return;
    ++counts.marks_within;
    // A pixel's tenth of a triangle some fifty pixels wide.
    const double told = std::min({double(truth.u), double(truth.v), 1 - double(truth.u) - double(truth.v)});
    REQUIRE(*depth > std::max(-0.02, told - 0.03));
    REQUIRE(*depth < told + 0.03);
  }
}

TEST_CASE("every family can be drawn, and the picture shows where the ray passes") {
  Counts counts;
  for (const Family& family : families()) {
    for (std::uint64_t i = 0; i < 150; ++i) {
      check_case(make<float>(family, 1, i).input, counts);
      check_case(make<double>(family, 1, i).input, counts);
    }
  }
  CHECK(counts.spheres > 1000);
  CHECK(counts.triangles > 1000);
  CHECK(counts.marks_within > 500);
}

TEST_CASE("a picture out of scale says so") {
  const auto caption = [](const Case<double>& input) { return drawn(input); };
  const RaySphere<double> far{{{0, 0, 0}, {1, 0, 0}}, {{0x1p600, 0.5, 0}, 1}};
  CHECK(caption(far).find("the origin is 2^600 radii from") != std::string::npos);
  const RaySphere<double> near_tangent{{{-2, 1 + 0x1p-40, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}};
  CHECK(caption(near_tangent).find("2^-40 radii beside a tangent") != std::string::npos);
  const RaySphere<double> plain{{{-2, 0.5, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}};
  CHECK(caption(plain).find("Not to scale") == std::string::npos);
  const RayTriangle<double> sliver{{{0.5, 0x1p-70, -1}, {0, 0, 1}}, {{0, 0, 0}, {1, 0, 0}, {0.5, 0x1p-60, 0}}};
  CHECK(caption(sliver).find("drawn in u and v") != std::string::npos);
  const RayTriangle<double> fine{{{0.25, 0.25, -1}, {0, 0, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  CHECK(caption(fine).find("Not to scale") == std::string::npos);
}

TEST_CASE("points and what is no number have no picture") {
  CHECK(drawn(Case<double>(PointLine<double>{{1, 2}, {3, 4, 5}})).empty());
  CHECK(drawn(Case<double>(RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{0.0 / 0.0, 0, 0}, 1}})).empty());
  CHECK(drawn(Case<double>(RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{1.0 / 0.0, 0, 0}, 1}})).empty());
  CHECK(drawing({{}, 0, "double", FloatMode::nearest, "no case", "", ""}).empty());
}

TEST_CASE("the histogram has a bar for each size that occurs, taller for more") {
  Tally tally;
  CHECK(error_histogram(tally).empty());
  tally.by_error[0] = 1;
  tally.by_error[7] = 1000000;
  tally.by_error[error_bins - 1] = 10;
  const std::string markup = error_histogram(tally);
  std::vector<double> heights;
  for (std::size_t at = 0; (at = markup.find("<rect", at)) != std::string::npos; ++at)
    heights.push_back(numbers(markup, "height", at).at(0));
  REQUIRE(heights.size() == 3);
  CHECK((heights[0] > 0 && heights[0] < heights[2] && heights[2] < heights[1]));
  CHECK(markup.find("&lt; 2^6: 1,000,000") != std::string::npos);
}

}  // namespace
}  // namespace graze::fuzz
