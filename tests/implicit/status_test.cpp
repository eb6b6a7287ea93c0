// Point and implicit surface: invalid and hostile input.
#include <limits>

#include "graze/implicit.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/hostile.hpp"

namespace graze::test {
namespace {

TEST_CASE("A number that is not finite is told before a radius below zero, and nothing else is told") {
  in_both_formats([]<Real T>() {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const Side non_finite{Status::non_finite, Sign::zero}, negative_radius{Status::negative_radius, Sign::zero};
    CHECK(side(Vec3<T>{nan, 0, 0}, Sphere<T>{{0, 0, 0}, -1}) == non_finite);
    CHECK(side(Vec3<T>{9, 0, 0}, Sphere<T>{{0, 0, 0}, -kInfinity<T>}) == non_finite);
    CHECK(side(Vec3<T>{9, 0, 0}, Sphere<T>{{0, 0, 0}, kInfinity<T>}) == non_finite);
    CHECK(side(Vec3<T>{9, 0, 0}, Sphere<T>{{0, 0, 0}, -1}) == negative_radius);
    CHECK(side(Vec3<T>{9, 0, 0}, Sphere<T>{{0, 0, 0}, -kLeast<T>}) == negative_radius);
    CHECK(side(Vec3<T>{0, 0, 0}, Sphere<T>{{0, 0, 0}, T(-0.0)}) == Side{Status::ok, Sign::zero});
    CHECK(side(Vec2<T>{1, 1}, Line<T>{0, 0, -kInfinity<T>}) == non_finite);
    CHECK(side(Vec2<T>{kInfinity<T>, 1}, Line<T>{0, 0, 1}) == non_finite);
    CHECK(side(Vec3<T>{1, 1, nan}, Plane<T>{1, 0, 0, 1}) == non_finite);
    CHECK(side(Vec3<T>{1, 1, 1}, Plane<T>{1, 0, 0, nan}) == non_finite);
  });
}

TEST_CASE("Points and surfaces: one or two hostile numbers, at every place") {
  in_both_formats([]<Real T>() {
    require_hostile_agreement<T>(fuzz::PointLine<T>{{3, 6}, {2, 3, 4}});
    require_hostile_agreement<T>(fuzz::PointPlane<T>{{1, 2, 3}, {1, -2, 2, -3}});
    require_hostile_agreement<T>(fuzz::PointSphere<T>{{1, 2, 4}, {{1, 0, 3}, 2}});
  });
}

}  // namespace
}  // namespace graze::test
