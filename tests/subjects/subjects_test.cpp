// The built-in subjects: their names, what each offers, and that each answers easy cases rightly.
#include <set>
#include <string>

#include "fuzz/answer_names.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/subject.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

const Case<double> ray_sphere = RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
const Case<double> ray_triangle = RayTriangle<double>{{{0.25, 0.5, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
const Case<double> point_line = PointLine<double>{{-11, 6}, {2, 3, 4}};
const Case<double> point_plane = PointPlane<double>{{0, 0, 0}, {1, -2, 2, -3}};
const Case<double> point_sphere = PointSphere<double>{{1, 2, 7}, {{1, 2, 3}, 3}};

// The queries that it answers, in their order.
template <Real T>
std::string offers(const Subject& subject) {
  std::string text;
  if (subject.answer(Case<T>(RaySphere<T>{}))) text += "ray_sphere ";
  if (subject.answer(Case<T>(RayTriangle<T>{}))) text += "ray_triangle ";
  if (subject.answer(Case<T>(PointLine<T>{}))) text += "point_line ";
  if (subject.answer(Case<T>(PointPlane<T>{}))) text += "point_plane ";
  if (subject.answer(Case<T>(PointSphere<T>{}))) text += "point_sphere ";
  return text;
}

}  // namespace

TEST_CASE("subjects are found by their names, graze first") {
  REQUIRE(!subjects().empty());
  CHECK(subjects()[0]->name() == "graze");
  std::set<std::string_view> names;
  for (const Subject* subject : subjects()) {
    CHECK(find_subject(subject->name()) == subject);
    CHECK(!subject->about().empty());
    CHECK(subject->about().find('\n') == std::string_view::npos);
    names.insert(subject->name());
  }
  CHECK(names.size() == subjects().size());
  CHECK(find_subject("") == nullptr);
  CHECK(find_subject("Graze") == nullptr);
}

TEST_CASE("each subject answers the queries that its formula has, in both precisions") {
  const auto check = [](std::string_view name, const std::string& queries) {
    CAPTURE(std::string(name));
    const Subject* subject = find_subject(name);
    REQUIRE(subject != nullptr);
    CHECK(offers<double>(*subject) == queries);
    CHECK(offers<float>(*subject) == queries);
  };
  check("graze", "ray_sphere ray_triangle point_line point_plane point_sphere ");
  check("textbook-naive", "ray_sphere point_line point_plane point_sphere ");
  check("textbook-stable", "ray_sphere ");
  check("textbook-repaired", "ray_sphere ");
  check("cramer", "ray_triangle ");
  check("moller-trumbore", "ray_triangle ");
  check("haines-sphere", "ray_sphere ");
  check("goualard-quadratic", "ray_sphere ");
  check("pbrt-interval", "ray_sphere ");
  check("woop-watertight", "ray_triangle ");
  check("cgal-epick", "ray_triangle ");
}

TEST_CASE("Embree, where it is built in, answers rays in float") {
  for (const Subject* subject : {find_subject("embree"), find_subject("embree-robust")}) {
    if (subject == nullptr) continue;
    CHECK(offers<float>(*subject) == "ray_sphere ray_triangle ");
    CHECK(offers<double>(*subject).empty());
    // Against its rules for rays.
    CHECK(!subject->answer(Case<float>(RaySphere<float>{{{0, 0, 0}, {1, 0, 0}, -1}, {{5, 0, 0}, 1}})));
    CHECK(!subject->answer(Case<float>(RaySphere<float>{{{1e19f, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}})));
  }
}

namespace {

/// The same case in the other precision.
Case<float> narrow(const Case<double>& input) {
  return std::get<Case<float>>(parse_case<float>(format_case(input)));
}

/// Right but for what the subject declares and `ulps`.
template <Real T>
void check_answer(const Subject& subject, const Case<T>& input, double ulps) {
  const auto reply = subject.answer(input);
  if (!reply) return;
  CAPTURE(format_case(input), format_answer(input, *reply, Details::yes));
  Deviations allowed = subject.deviations();
  allowed.t_ulps = allowed.uv_ulps = ulps;
  const oracle::Oracle& oracle = oracle::gmp_oracle();
  CHECK(compare(input, *reply, answer_of(oracle, input), oracle, allowed).disagreement == Disagreement::none);
}

}  // namespace

TEST_CASE("easy cases are answered rightly by all, but for what they declare") {
  const Case<double> from_inside = RaySphere<double>{{{5.25, 0.5, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  const Case<double> past_sphere = RaySphere<double>{{{0, 3, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  const Case<double> scaled = RaySphere<double>{{{0.25, -0.5, 3}, {2, 3, -20}}, {{2, 1, -9}, 4}};
  const Case<double> in_range = RaySphere<double>{{{0, 0, 0}, {1, 0, 0}, 4.5, 9}, {{5, 0, 0}, 1}};
  const Case<double> from_behind = RayTriangle<double>{{{0.25, 0.5, -2}, {0.125, 0, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Case<double> past_triangle = RayTriangle<double>{{{0.75, 0.5, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const Case<double> tilted = RayTriangle<double>{{{1, 2, 3}, {-3, 1, -4}}, {{0, 0, 0}, {-1, 5, 1}, {0, 1, -2}}};
  const Case<double> cut_off = RayTriangle<double>{{{0.25, 0.5, 1}, {0, 0, -1}, 0, 0.5}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  for (const Subject* subject : subjects()) {
    CAPTURE(std::string(subject->name()));
    for (const Case<double>& input : {ray_sphere, from_inside, past_sphere, scaled, in_range, ray_triangle, from_behind,
                                      past_triangle, tilted, cut_off, point_line, point_plane, point_sphere}) {
      check_answer(*subject, input, 64);
      check_answer(*subject, narrow(input), 64);
    }
  }
  // The kernel needs no allowance.
  check_answer(*find_subject("graze"), scaled, 0.5);
}

TEST_CASE("what each formula was made for") {
  const auto kind = [](std::string_view name, const Case<double>& input) {
    const Answer<double> answer = *find_subject(name)->answer(input);
    const auto* sphere = std::get_if<SphereHit<double>>(&answer);
    return sphere != nullptr ? std::string(name_of(sphere->kind))
                             : std::string(name_of(std::get<TriangleHit<double>>(answer).kind));
  };
  // A small sphere far away: B^2 - 4AC loses it, the perpendicular remainder does not.
  const Case<double> far = RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{0x1p30, 0x1p-1, 0}, 1}};
  CHECK(kind("textbook-stable", far) == "tangent");
  CHECK(kind("haines-sphere", far) == "secant");
  // Coefficients of which the squares overflow.
  const Case<double> large = RaySphere<double>{{{0, 0, 0}, {0x1p511, 0, 0}}, {{5, 0, 0}, 1}};
  CHECK(kind("textbook-stable", large) == "miss");
  CHECK(kind("goualard-quadratic", large) == "secant");
  // A tangent is in doubt for intervals.
  const Case<double> tangent = RaySphere<double>{{{0, 1, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  CHECK(kind("textbook-stable", tangent) == "tangent");
  CHECK(kind("pbrt-interval", tangent) == "miss");
  // Corners and edges are told apart by signs of zero.
  const auto down = [](double x, double y) {
    return RayTriangle<double>{{{x, y, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  };
  CHECK(kind("woop-watertight", down(0, 0)) == "vertex_a");
  CHECK(kind("woop-watertight", down(1, 0)) == "vertex_b");
  CHECK(kind("woop-watertight", down(0, 1)) == "vertex_c");
  CHECK(kind("woop-watertight", down(0.25, 0)) == "edge_ab");
  CHECK(kind("woop-watertight", down(0.25, 0.75)) == "edge_bc");
  CHECK(kind("woop-watertight", down(0, 0.25)) == "edge_ca");
  // CGAL constructs the common segment.
  const Case<double> coplanar = RayTriangle<double>{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}}};
  CHECK(kind("cgal-epick", coplanar) == "coplanar");
  CHECK(kind("cgal-epick", down(0.25, 0)) == "face");
}

TEST_CASE("the forms of the quadratic are told apart at B = 0") {
  // From the center of a sphere of radius 2.
  const Case<double> input = RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 2}};
  const auto nearest = [&](std::string_view name) {
    return std::get<SphereHit<double>>(*find_subject(name)->answer(input)).t[0];
  };
  CHECK(nearest("textbook-naive") == 2);
  CHECK(nearest("textbook-stable") == 0);
  CHECK(nearest("textbook-repaired") == 2);
}
