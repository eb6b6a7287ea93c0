// The built-in subjects: their names, what each offers, and that each answers easy cases rightly.
#include <set>
#include <string>

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
}

TEST_CASE("easy cases are answered alike by all") {
  for (const Subject* subject : subjects()) {
    CAPTURE(std::string(subject->name()));
    const auto check = [&](const Case<double>& input, const Answer<double>& wanted) {
      const auto answer = subject->answer(input);
      if (answer) CHECK((*answer == wanted));
    };
    check(ray_sphere, SphereHit<double>{Status::ok, SphereKind::secant, Root::both, OriginSide::outside, {4, 6}});
    check(ray_triangle, TriangleHit<double>{Status::ok, TriangleKind::face, Facing::front, 1, 1, 0.25, 0.5});
    check(point_line, Side{Status::ok, Sign::zero});
    check(point_plane, Side{Status::ok, Sign::negative});
    check(point_sphere, Side{Status::ok, Sign::positive});
  }
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
