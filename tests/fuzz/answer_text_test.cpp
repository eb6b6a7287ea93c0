// Answer lines, with details and without.
#include <limits>
#include <string>
#include <utility>

#include "fuzz/case_text.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

TEST_CASE("a sphere's answer is its kind and its values") {
  const Case<double> input = RaySphere<double>{};
  const auto line = [&](const SphereHit<double>& hit, Details details) {
    return format_answer(input, Answer<double>(hit), details);
  };
  const SphereHit<double> both{Status::ok, SphereKind::secant, Root::both, OriginSide::outside, {4, 6}};
  CHECK(line(both, Details::no) == "secant 4 6");
  CHECK(line(both, Details::yes) == "secant 4 6 origin=outside root=both");
  const SphereHit<double> second{Status::ok, SphereKind::secant, Root::second, OriginSide::inside, {0.1, 0}};
  CHECK(line(second, Details::no) == "secant 0.1");
  CHECK(line(second, Details::yes) == "secant 0.1 origin=inside root=second");
  const SphereHit<double> first{
      Status::ok, SphereKind::secant, Root::first, OriginSide::outside, {std::numeric_limits<double>::infinity(), 0}};
  CHECK(line(first, Details::yes) == "secant inf origin=outside root=first");
  const SphereHit<double> tangent{Status::ok, SphereKind::tangent, Root::both, OriginSide::on, {5, 0}};
  CHECK(line(tangent, Details::no) == "tangent 5");
  CHECK(line(tangent, Details::yes) == "tangent 5 origin=on root=both");
  const SphereHit<double> miss{Status::ok, SphereKind::miss, Root::none, OriginSide::outside, {0, 0}};
  CHECK(line(miss, Details::no) == "miss");
  CHECK(line(miss, Details::yes) == "miss origin=outside");
  for (const auto& [status, text] :
       {std::pair{Status::non_finite, "invalid non_finite"}, std::pair{Status::zero_direction, "invalid zero_direction"},
        std::pair{Status::negative_radius, "invalid negative_radius"}, std::pair{Status::empty_range, "invalid empty_range"}}) {
    CHECK(line({status, SphereKind::invalid}, Details::yes) == text);
  }
}

TEST_CASE("a triangle's answer is its kind and its values") {
  const Case<float> input = RayTriangle<float>{};
  const auto line = [&](const TriangleHit<float>& hit, Details details) {
    return format_answer(input, Answer<float>(hit), details);
  };
  TriangleHit<float> hit{Status::ok, TriangleKind::edge_bc, Facing::front, 1.5F, 1.5F, 0.25F, 0.75F};
  CHECK(line(hit, Details::no) == "edge_bc 1.5 0.25 0.75");
  CHECK(line(hit, Details::yes) == "edge_bc 1.5 0.25 0.75 facing=front");
  for (const auto& [kind, text] :
       {std::pair{TriangleKind::face, "face"}, std::pair{TriangleKind::edge_ab, "edge_ab"},
        std::pair{TriangleKind::edge_ca, "edge_ca"}, std::pair{TriangleKind::vertex_a, "vertex_a"},
        std::pair{TriangleKind::vertex_b, "vertex_b"}, std::pair{TriangleKind::vertex_c, "vertex_c"}}) {
    hit.kind = kind;
    CHECK(line(hit, Details::no) == std::string(text) + " 1.5 0.25 0.75");
  }
  CHECK(line({Status::ok, TriangleKind::coplanar, Facing::none, 1, 2}, Details::yes) == "coplanar 1 2 facing=none");
  CHECK(line({Status::ok, TriangleKind::degenerate, Facing::none, 0.1F, 0.1F}, Details::no) == "degenerate 0.1 0.1");
  CHECK(line({Status::ok, TriangleKind::miss, Facing::back}, Details::no) == "miss");
  CHECK(line({Status::ok, TriangleKind::miss, Facing::back}, Details::yes) == "miss facing=back");
  CHECK(line({Status::zero_direction, TriangleKind::invalid}, Details::yes) == "invalid zero_direction");
}

TEST_CASE("a side is called after the surface") {
  const auto words = [](const Case<double>& input) {
    std::string text;
    for (const Sign sign : {Sign::negative, Sign::zero, Sign::positive}) {
      text += format_answer(input, Answer<double>(Side{Status::ok, sign}), Details::yes) + " ";
    }
    return text;
  };
  CHECK(words(PointLine<double>{}) == "negative on positive ");
  CHECK(words(PointPlane<double>{}) == "negative on positive ");
  CHECK(words(PointSphere<double>{}) == "inside on outside ");
  CHECK(format_answer(Case<double>(PointSphere<double>{}), Answer<double>(Side{Status::negative_radius, {}})) ==
        "invalid negative_radius");
  CHECK(format_answer(Case<double>(PointLine<double>{}), Answer<double>(Side{Status::non_finite, {}})) == "invalid non_finite");
}
