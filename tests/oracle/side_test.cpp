// Implicit surfaces: the exact sign of f(p), computed by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

constexpr Side kNegative{Status::ok, Sign::negative};
constexpr Side kOn{Status::ok, Sign::zero};
constexpr Side kPositive{Status::ok, Sign::positive};
constexpr Side kNonFinite{Status::non_finite, Sign::zero};

TEST_CASE("A point and a line") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Line<T> line{1, 2, -3};
    CHECK(oracle.side(Vec2<T>{1, 1}, line) == kOn);
    CHECK(oracle.side(Vec2<T>{0, 0}, line) == kNegative);
    CHECK(oracle.side(Vec2<T>{2, 1}, line) == kPositive);
    // A hair beside the point, in x and in y.
    CHECK(oracle.side(Vec2<T>{std::nextafter(T(1), T(2)), 1}, line) == kPositive);
    CHECK(oracle.side(Vec2<T>{1, std::nextafter(T(1), T(0))}, line) == kNegative);
    // Both products overflow and cancel; the constant alone decides.
    const T big = kGreatest<T>;
    CHECK(oracle.side(Vec2<T>{big, big}, Line<T>{big, -big, kLeast<T>}) == kPositive);
    CHECK(oracle.side(Vec2<T>{big, big}, Line<T>{big, -big, 0}) == kOn);
    // A product far below the least number is not zero.
    CHECK(oracle.side(Vec2<T>{kLeast<T>, 0}, Line<T>{-kLeast<T>, 0, 0}) == kNegative);
  });
}

TEST_CASE("A constant is a valid line and a valid plane") {
  everywhere([]<Real T>(const Oracle& oracle) {
    CHECK(oracle.side(Vec2<T>{7, 7}, Line<T>{0, 0, -1}) == kNegative);
    CHECK(oracle.side(Vec2<T>{7, 7}, Line<T>{0, T(-0.0), T(-0.0)}) == kOn);
    CHECK(oracle.side(Vec3<T>{7, 7, 7}, Plane<T>{0, 0, 0, kLeast<T>}) == kPositive);
    CHECK(oracle.side(Vec3<T>{7, 7, 7}, Plane<T>{0, 0, 0, 0}) == kOn);
  });
}

TEST_CASE("A point and a plane") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Plane<T> plane{1, 1, 1, -3};
    CHECK(oracle.side(Vec3<T>{1, 1, 1}, plane) == kOn);
    CHECK(oracle.side(Vec3<T>{1, 1, std::nextafter(T(1), T(2))}, plane) == kPositive);
    CHECK(oracle.side(Vec3<T>{1, 1, std::nextafter(T(1), T(0))}, plane) == kNegative);
    CHECK(oracle.side(Vec3<T>{kLeast<T>, 0, 0}, Plane<T>{kLeast<T>, 1, 1, 0}) == kPositive);
  });
}

TEST_CASE("A point and a sphere") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Sphere<T> sphere{{1, 1, 1}, 3};
    CHECK(oracle.side(Vec3<T>{2, 3, 3}, sphere) == kOn);
    CHECK(oracle.side(Vec3<T>{1, 1, 1}, sphere) == kNegative);
    CHECK(oracle.side(Vec3<T>{4, 4, 1}, sphere) == kPositive);
    CHECK(oracle.side(Vec3<T>{2, 3, std::nextafter(T(3), T(2))}, sphere) == kNegative);
    CHECK(oracle.side(Vec3<T>{2, 3, std::nextafter(T(3), T(4))}, sphere) == kPositive);
    CHECK(oracle.side(Vec3<T>{1, 1, 1}, Sphere<T>{{1, 1, 1}, T(-0.0)}) == kOn);
    // r^2 underflows, the distance squared does too, and they are not equal.
    CHECK(oracle.side(Vec3<T>{kLeast<T>, kLeast<T>, 0}, Sphere<T>{{0, 0, 0}, kLeast<T>}) == kPositive);
    CHECK(oracle.side(Vec3<T>{kLeast<T>, 0, 0}, Sphere<T>{{0, 0, 0}, kLeast<T>}) == kOn);
    CHECK(oracle.side(Vec3<T>{-kGreatest<T>, 0, 0}, Sphere<T>{{kGreatest<T>, 0, 0}, kGreatest<T>}) == kPositive);
  });
}

TEST_CASE("Invalid points and surfaces have no side") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(oracle.side(Vec2<T>{nan, 0}, Line<T>{1, 1, 1}) == kNonFinite);
    CHECK(oracle.side(Vec2<T>{0, kInfinity<T>}, Line<T>{0, 0, 1}) == kNonFinite);
    CHECK(oracle.side(Vec2<T>{0, 0}, Line<T>{1, 1, kInfinity<T>}) == kNonFinite);
    CHECK(oracle.side(Vec3<T>{0, 0, -kInfinity<T>}, Plane<T>{0, 0, 0, 1}) == kNonFinite);
    CHECK(oracle.side(Vec3<T>{0, 0, 0}, Plane<T>{0, 0, nan, 1}) == kNonFinite);
    CHECK(oracle.side(Vec3<T>{0, nan, 0}, Sphere<T>{{0, 0, 0}, -1}) == kNonFinite);
    CHECK(oracle.side(Vec3<T>{0, 0, 0}, Sphere<T>{{0, 0, 0}, kInfinity<T>}) == kNonFinite);
    CHECK(oracle.side(Vec3<T>{0, 0, 0}, Sphere<T>{{0, 0, 0}, -1}) == (Side{Status::negative_radius, Sign::zero}));
  });
}

}  // namespace
}  // namespace graze::oracle
