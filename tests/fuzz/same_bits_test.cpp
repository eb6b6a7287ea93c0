// Equality of answers to the bit.
#include "fuzz/same_bits.hpp"

#include <limits>

#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

TEST_CASE("zeros differ by their sign, and a NaN equals itself") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(same_bits(0.0, 0.0));
  CHECK(!same_bits(0.0, -0.0));
  CHECK(!same_bits(0.0F, -0.0F));
  CHECK(same_bits(nan, nan));
  CHECK(!same_bits(nan, -nan));
}

TEST_CASE("each field of an answer counts") {
  const SphereHit<double> sphere{Status::ok, SphereKind::secant, Root::both, OriginSide::outside, {4, 6}};
  const auto sphere_differs = [&](auto change) {
    SphereHit<double> other = sphere;
    change(other);
    return !same_bits(Answer<double>(sphere), Answer<double>(other));
  };
  CHECK(!sphere_differs([](auto&) {}));
  CHECK(sphere_differs([](auto& hit) { hit.status = Status::non_finite; }));
  CHECK(sphere_differs([](auto& hit) { hit.kind = SphereKind::tangent; }));
  CHECK(sphere_differs([](auto& hit) { hit.root = Root::first; }));
  CHECK(sphere_differs([](auto& hit) { hit.origin = OriginSide::on; }));
  CHECK(sphere_differs([](auto& hit) { hit.t[0] = 5; }));
  CHECK(sphere_differs([](auto& hit) { hit.t[1] = 5; }));

  const TriangleHit<float> triangle{Status::ok, TriangleKind::face, Facing::front, 1, 1, 0, 0.5F};
  const auto triangle_differs = [&](auto change) {
    TriangleHit<float> other = triangle;
    change(other);
    return !same_bits(Answer<float>(triangle), Answer<float>(other));
  };
  CHECK(!triangle_differs([](auto&) {}));
  CHECK(triangle_differs([](auto& hit) { hit.status = Status::non_finite; }));
  CHECK(triangle_differs([](auto& hit) { hit.kind = TriangleKind::edge_ca; }));
  CHECK(triangle_differs([](auto& hit) { hit.facing = Facing::back; }));
  CHECK(triangle_differs([](auto& hit) { hit.t = 2; }));
  CHECK(triangle_differs([](auto& hit) { hit.t_end = 2; }));
  CHECK(triangle_differs([](auto& hit) { hit.u = -0.0F; }));
  CHECK(triangle_differs([](auto& hit) { hit.v = 0; }));

  CHECK(same_bits(Answer<float>(Side{}), Answer<float>(Side{})));
  CHECK(!same_bits(Answer<float>(Side{}), Answer<float>(Side{Status::ok, Sign::positive})));
  CHECK(!same_bits(Answer<float>(Side{}), Answer<float>(triangle)));
}
