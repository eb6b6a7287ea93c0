// The implicit forms on the examples of the course, and the failures that their docstrings name.
#include "graze/textbook/implicit.hpp"

#include <cmath>

#include "tests/catch.hpp"

using graze::Line;
using graze::Plane;
using graze::Sphere;
using graze::Vec2;
using graze::Vec3;
using graze::textbook::f;

TEST_CASE("f(x, y) = 2x + 3y + 4 tells which points lie on the line") {
  const Line<double> line{2, 3, 4};
  CHECK(f(Vec2<double>{3, 6}, line) == 28);   // not on it
  CHECK(f(Vec2<double>{-11, 6}, line) == 0);  // on it: 2 * -11 + 3 * 6 + 4
  CHECK(f(Vec2<float>{3, 6}, Line<float>{2, 3, 4}) == 28);
  CHECK(f(Vec2<float>{-11, 6}, Line<float>{2, 3, 4}) == 0);
  CHECK(f(Vec2<double>{-12, 6}, line) < 0);
}

TEST_CASE("a line with a = b = 0 is a constant") {
  CHECK(f(Vec2<double>{7, -9}, Line<double>{0, 0, -2}) == -2);
}

TEST_CASE("the plane's f has the sides of its normal") {
  const Plane<double> plane{1, -2, 2, -3};
  CHECK(f(Vec3<double>{3, 0, 0}, plane) == 0);
  CHECK(f(Vec3<double>{4, -2, 2}, plane) == 9);  // the normal's tip is 3 further along a normal of length 3
  CHECK(f(Vec3<double>{0, 0, 0}, plane) == -3);
}

TEST_CASE("the sphere's f is negative inside, 0 on it and positive outside") {
  const Sphere<double> sphere{{1, 2, 3}, 3};
  CHECK(f(Vec3<double>{1, 2, 3}, sphere) == -9);
  CHECK(f(Vec3<double>{2, 4, 5}, sphere) == 0);  // (1, 2, 2) has length 3
  CHECK(f(Vec3<double>{1, 2, 7}, sphere) == 7);
  CHECK(f(Vec3<float>{2, 4, 5}, Sphere<float>{{1, 2, 3}, 3}) == 0);
}

TEST_CASE("f in floating point calls points on the surface that are not") {
  // The exact value is 1: 2^53 + 1 - 2^53.
  const double big = 9007199254740992.0;
  CHECK(f(Vec2<double>{big, 1}, Line<double>{1, 1, -big}) == 0);
  // (1 + 2^-52)(1 - 2^-52) - 1 = -2^-104 rounds to 0 before it is seen.
  const double ulp = std::ldexp(1.0, -52);
  CHECK(f(Vec2<double>{1 + ulp, 0}, Line<double>{1 - ulp, 0, -1}) == 0);
  // A point at 2^-600 is outside the sphere of radius 2^-601; both squares underflow.
  CHECK(f(Vec3<double>{std::ldexp(1.0, -600), 0, 0}, Sphere<double>{{}, std::ldexp(1.0, -601)}) == 0);
  // Outside by far, and no number at all: infinity - infinity.
  CHECK(std::isnan(f(Vec3<double>{1e300, 0, 0}, Sphere<double>{{}, 1e200})));
}
