// Answer lines read back.
#include "fuzz/answer_text.hpp"

#include <limits>

#include "fuzz/same_bits.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

const Case<double> sphere = RaySphere<double>{};
const Case<double> triangle = RayTriangle<double>{};
const Case<double> plane = PointPlane<double>{};
const Case<double> ball = PointSphere<double>{};

template <Real T>
void check_round_trip(const Case<T>& input, const Answer<T>& answer) {
  const std::string line = format_answer(input, answer, Details::yes);
  CAPTURE(line);
  const auto read = parse_answer(input, line);
  REQUIRE(std::holds_alternative<Answer<T>>(read));
  CHECK(same_bits(std::get<Answer<T>>(read), answer));
}

/// What is wrong with the line; empty where nothing is.
std::string error(const Case<double>& input, std::string_view line) {
  const auto read = parse_answer(input, line);
  const auto* wrong = std::get_if<LineError>(&read);
  return wrong == nullptr ? "" : wrong->what;
}

Answer<double> read(const Case<double>& input, std::string_view line) {
  return std::get<Answer<double>>(parse_answer(input, line));
}

}  // namespace

TEST_CASE("answers with details read back to the same bits") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const OriginSide origin : {OriginSide::inside, OriginSide::on, OriginSide::outside}) {
    check_round_trip<double>(sphere, SphereHit<double>{Status::ok, SphereKind::miss, Root::none, origin, {}});
    check_round_trip<double>(sphere, SphereHit<double>{Status::ok, SphereKind::tangent, Root::both, origin, {1.0 / 3, 0}});
    check_round_trip<double>(sphere, SphereHit<double>{Status::ok, SphereKind::secant, Root::both, origin, {-0.0, infinity}});
    check_round_trip<double>(sphere, SphereHit<double>{Status::ok, SphereKind::secant, Root::first, origin, {5e-324, 0}});
    check_round_trip<double>(sphere, SphereHit<double>{Status::ok, SphereKind::secant, Root::second, origin, {1e300, 0}});
  }
  for (int kind = static_cast<int>(TriangleKind::miss); kind <= static_cast<int>(TriangleKind::degenerate); ++kind) {
    for (const Facing facing : {Facing::none, Facing::front, Facing::back}) {
      TriangleHit<double> hit{Status::ok, static_cast<TriangleKind>(kind), facing};
      if (hit.is_interval()) {
        hit.t = 0.1;
        hit.t_end = 0.7;
      } else if (hit.kind != TriangleKind::miss) {
        hit.t = hit.t_end = 0.1;
        hit.u = 0x1.23456789abcdep-3;
        hit.v = 0.5;
      }
      check_round_trip<double>(triangle, hit);
    }
  }
  check_round_trip<float>(Case<float>(RayTriangle<float>{}),
                          TriangleHit<float>{Status::ok, TriangleKind::face, Facing::back, 0.1f, 0.1f, 0x1.abcdep-9f, 0.2f});
  for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive}) {
    check_round_trip<double>(plane, Side{Status::ok, sign});
    check_round_trip<double>(ball, Side{Status::ok, sign});
  }
  for (const Status status : {Status::non_finite, Status::zero_direction, Status::negative_radius, Status::empty_range}) {
    check_round_trip<double>(sphere, SphereHit<double>{status, SphereKind::invalid});
    check_round_trip<double>(triangle, TriangleHit<double>{status, TriangleKind::invalid});
    check_round_trip<double>(plane, Side{status, Sign::zero});
  }
}

TEST_CASE("what a program need not tell") {
  CHECK(std::get<SphereHit<double>>(read(sphere, "secant 4 6")).root == Root::both);
  CHECK(std::get<SphereHit<double>>(read(sphere, "secant 4")).root == Root::first);
  CHECK(std::get<SphereHit<double>>(read(sphere, "  hit  4  ")).kind == SphereKind::secant);
  CHECK(std::get<TriangleHit<double>>(read(triangle, "hit 4")).kind == TriangleKind::face);
  const auto hit = std::get<TriangleHit<double>>(read(triangle, "face 4"));
  CHECK((hit.t == 4 && hit.t_end == 4 && hit.u == 0 && hit.facing == Facing::none));
}

TEST_CASE("lines that are no answers") {
  CHECK(error(sphere, "") == "there is no kind of ray_sphere");
  CHECK(error(sphere, "face 1 0 0") == "'face' is no kind of ray_sphere");
  CHECK(error(triangle, "secant 1") == "'secant' is no kind of ray_triangle");
  CHECK(error(plane, "inside") == "'inside' is no sign");
  CHECK(error(ball, "negative") == "'negative' is no side of a sphere");
  CHECK(error(plane, "on 1") == "on takes no value");
  CHECK(error(sphere, "miss 1") == "miss takes no value");
  CHECK(error(sphere, "tangent 1 2") == "tangent takes one value, t");
  CHECK(error(sphere, "secant") == "secant takes one value or two, the roots");
  CHECK(error(sphere, "secant 1 2 root=first") == "root=first does not go with 2 values");
  CHECK(error(sphere, "secant 1 root=both") == "root=both does not go with 1 value");
  CHECK(error(sphere, "secant 1 root=third") == "'third' is no root");
  CHECK(error(sphere, "miss origin=nowhere") == "'nowhere' is no side of the origin");
  CHECK(error(triangle, "face 1 2") == "face takes t, or t u v");
  CHECK(error(triangle, "face 1 2 3 4") == "'4' is a number too many");
  CHECK(error(triangle, "face 1 0.25 0.5 x") == "'x' is neither a number nor a detail");
  CHECK(error(triangle, "coplanar 1") == "coplanar takes two values, the ends of the common part");
  CHECK(error(triangle, "miss facing=up") == "'up' is no facing");
  CHECK(error(triangle, "invalid") == "there is no status");
  CHECK(error(triangle, "invalid ok") == "'ok' is no status");
  CHECK(error(triangle, "\xff\x01") == "'\\xff\\x01' is no kind of ray_triangle");
}
