// Point and implicit surface by hand.
#include <cmath>

#include "graze/implicit.hpp"
#include "tests/catch.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

constexpr Side negative{Status::ok, Sign::negative}, on{Status::ok, Sign::zero}, positive{Status::ok, Sign::positive};

TEST_CASE("The line 2x + 3y + 4 = 0") {
  in_both_formats([]<Real T>() {
    const Line<T> line{2, 3, 4};
    CHECK(side(Vec2<T>{3, 6}, line) == positive);  // 28
    CHECK(side(Vec2<T>{-11, 6}, line) == on);
    CHECK(side(Vec2<T>{-12, 6}, line) == negative);
    CHECK(side(Vec2<T>{std::nextafter(T(-11), T(0)), 6}, line) == positive);
    CHECK(side(Vec2<T>{-11, std::nextafter(T(6), T(0))}, line) == negative);
    CHECK(side(Vec2<T>{-11, 6}, Line<T>{2, 3, std::nextafter(T(4), T(5))}) == positive);
  });
}

TEST_CASE("A line or a plane whose f is a constant is valid") {
  in_both_formats([]<Real T>() {
    const T huge = kGreatest<T>;
    CHECK(side(Vec2<T>{huge, -huge}, Line<T>{0, 0, kLeast<T>}) == positive);
    CHECK(side(Vec2<T>{huge, -huge}, Line<T>{0, T(-0.0), -kLeast<T>}) == negative);
    CHECK(side(Vec2<T>{huge, -huge}, Line<T>{0, 0, T(-0.0)}) == on);
    CHECK(side(Vec3<T>{huge, huge, huge}, Plane<T>{0, 0, 0, -1}) == negative);
    CHECK(side(Vec3<T>{huge, huge, huge}, Plane<T>{}) == on);
  });
}

TEST_CASE("The plane x - 2y + 2z - 3 = 0") {
  in_both_formats([]<Real T>() {
    const Plane<T> plane{1, -2, 2, -3};
    CHECK(side(Vec3<T>{3, 0, 0}, plane) == on);
    CHECK(side(Vec3<T>{1, 1, 2}, plane) == on);
    CHECK(side(Vec3<T>{0, 0, 0}, plane) == negative);
    CHECK(side(Vec3<T>{3, 0, kLeast<T>}, plane) == positive);
    CHECK(side(Vec3<T>{3, kLeast<T>, 0}, plane) == negative);
    CHECK(side(Vec3<T>{3, kLeast<T>, kLeast<T>}, plane) == on);
  });
}

TEST_CASE("Signs that working precision cannot see") {
  in_both_formats([]<Real T>() {
    // (1 + eps)(1 - eps) - 1 = -eps^2.
    const T eps = std::numeric_limits<T>::epsilon();
    CHECK(side(Vec2<T>{1 + eps, 0}, Line<T>{1 - eps, 0, -1}) == negative);
    // Large terms that cancel but for the last.
    CHECK(side(Vec3<T>{kGreatest<T>, kGreatest<T>, 1}, Plane<T>{kGreatest<T>, -kGreatest<T>, kLeast<T>, 0}) == positive);
    CHECK(side(Vec3<T>{kGreatest<T>, kGreatest<T>, 1}, Plane<T>{kGreatest<T>, -kGreatest<T>, kLeast<T>, -kLeast<T>}) == on);
  });
}

TEST_CASE("The sphere around (1, 2, 3) through (3, 4, 4)") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{1, 2, 3}, 3};
    CHECK(side(Vec3<T>{1, 2, 3}, sphere) == negative);
    CHECK(side(Vec3<T>{3, 4, 4}, sphere) == on);
    CHECK(side(Vec3<T>{-1, 0, 2}, sphere) == on);
    CHECK(side(Vec3<T>{9, 9, 9}, sphere) == positive);
    CHECK(side(Vec3<T>{std::nextafter(T(3), T(4)), 4, 4}, sphere) == positive);
    CHECK(side(Vec3<T>{std::nextafter(T(3), T(0)), 4, 4}, sphere) == negative);
    CHECK(side(Vec3<T>{3, 4, 4}, Sphere<T>{{1, 2, 3}, std::nextafter(T(3), T(4))}) == negative);
  });
}

TEST_CASE("A sphere of radius zero has no inside") {
  in_both_formats([]<Real T>() {
    CHECK(side(Vec3<T>{1, 2, 3}, Sphere<T>{{1, 2, 3}, 0}) == on);
    CHECK(side(Vec3<T>{1, 2, std::nextafter(T(3), T(4))}, Sphere<T>{{1, 2, 3}, 0}) == positive);
    CHECK(side(Vec3<T>{kLeast<T>, 0, 0}, Sphere<T>{{0, 0, 0}, 0}) == positive);
  });
}

}  // namespace
}  // namespace graze::test
