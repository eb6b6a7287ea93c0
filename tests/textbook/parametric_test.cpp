// Points by their parameters.
#include "graze/textbook/parametric.hpp"

#include "graze/textbook/implicit.hpp"
#include "tests/catch.hpp"

using graze::Ray;
using graze::Sphere;
using graze::Triangle;
using graze::Vec3;
using graze::textbook::f;
using graze::textbook::point_at;

TEST_CASE("a ray's point is e + t d") {
  const Ray<double> ray{{1, 2, 3}, {2, 0, -1}};
  CHECK(point_at(ray, 0.0) == ray.origin);
  CHECK(point_at(ray, 1.5) == Vec3<double>{4, 2, 1.5});
  CHECK(point_at(ray, -1.0) == Vec3<double>{-1, 2, 4});
}

TEST_CASE("a triangle's point is a + u (b - a) + v (c - a)") {
  const Triangle<double> triangle{{1, 1, 1}, {5, 1, 1}, {1, 9, 1}};
  CHECK(point_at(triangle, 0.0, 0.0) == triangle.a);
  CHECK(point_at(triangle, 1.0, 0.0) == triangle.b);
  CHECK(point_at(triangle, 0.0, 1.0) == triangle.c);
  CHECK(point_at(triangle, 0.25, 0.5) == Vec3<double>{2, 5, 1});
}

TEST_CASE("computed points leave what they should lie on") {
  // b - a rounds to -a, so u = 1 gives 0 and not b.
  const Triangle<double> triangle{{1e16, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(point_at(triangle, 1.0, 0.0) != triangle.b);
  // (2, 3, 6) has length 7: the ray meets the unit sphere at t = 1/7, which is no double; at the nearest one it is inside.
  const Ray<double> ray{{0, 0, 0}, {2, 3, 6}};
  CHECK(f(point_at(ray, 1.0 / 7), Sphere<double>{{}, 1}) < 0);
}
