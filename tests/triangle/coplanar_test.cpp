// A ray in the triangle's plane, or parallel to it, by hand; with the axes turned, so that each is once the one to project
// along.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/isometry.hpp"
#include "tests/triangle/corners.hpp"

namespace graze::test {
namespace {

using enum TriangleKind;

/// All corners' orders and all turned and reflected axes: the common part is the same.
template <Real T>
void check_turned(const Ray<T>& ray, const TriangleHit<T>& expected) {
  for (const Triangle<T>& triangle : all_orders(right<T>)) {
    each_isometry([&](const Isometry& isometry) {
      const fuzz::RayTriangle<T> turned = isometry(fuzz::RayTriangle<T>{ray, triangle});
      check_answer(turned.ray, turned.triangle, expected);
    });
  }
}

template <Real T>
const TriangleHit<T> no_hit = triangle_miss<T>(Facing::none);

TEST_CASE("A coplanar ray that crosses") {
  in_both_formats([]<Real T>() {
    check_turned(Ray<T>{{-1, 1, 0}, {1, 0, 0}}, along<T>(coplanar, 1, 4));
    check_turned(Ray<T>{{1, 1, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 2));
    check_turned(Ray<T>{{1, 1, 0}, {2, 2, 0}}, along<T>(coplanar, 0, T(0.5)));
    check_turned(Ray<T>{{-1, -1, 0}, {1, 1, 0}}, along<T>(coplanar, 1, 3));
    check_turned(Ray<T>{{-1, 2, 0}, {3, -1, 0}}, along<T>(coplanar, T(1) / T(3), T(1.5)));
    check_turned(Ray<T>{{5, 1, 0}, {1, 0, 0}}, no_hit<T>);
    check_turned(Ray<T>{{5, 5, 0}, {-1, 1, 0}}, no_hit<T>);
  });
}

TEST_CASE("A coplanar ray that touches a corner") {
  in_both_formats([]<Real T>() {
    check_turned(Ray<T>{{4, -1, 0}, {0, 1, 0}}, along<T>(coplanar, 1, 1));
    check_turned(Ray<T>{{-2, 2, 0}, {1, -1, 0}}, along<T>(coplanar, 2, 2));
    check_turned(Ray<T>{{-3, 4, 0}, {1, 0, 0}}, along<T>(coplanar, 3, 3));
    check_turned(Ray<T>{{4, 0, 0}, {0, -1, 0}}, along<T>(coplanar, 0, 0));
    check_turned(Ray<T>{{4, 1, 0}, {0, 1, 0}}, no_hit<T>);
    check_turned(Ray<T>{{std::nextafter(T(4), T(5)), -1, 0}, {0, 1, 0}}, no_hit<T>);
    check_turned(Ray<T>{{-kLeast<T>, 0, 0}, {0, 1, 0}}, no_hit<T>);
  });
}

TEST_CASE("A coplanar ray on an edge's line: toward the edge, on it, at its end, away from it") {
  in_both_formats([]<Real T>() {
    check_turned(Ray<T>{{-1, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 1, 5));
    check_turned(Ray<T>{{1, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 3));
    check_turned(Ray<T>{{4, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 0));
    check_turned(Ray<T>{{5, 0, 0}, {1, 0, 0}}, no_hit<T>);
    check_turned(Ray<T>{{5, -1, 0}, {-1, 1, 0}}, along<T>(coplanar, 1, 5));
    check_turned(Ray<T>{{-1, 5, 0}, {-1, 1, 0}}, no_hit<T>);
    check_turned(Ray<T>{{0, 5, 0}, {0, -3, 0}}, along<T>(coplanar, T(1) / T(3), T(5) / T(3)));
  });
}

TEST_CASE("A parallel ray off the plane misses, by however little") {
  in_both_formats([]<Real T>() {
    check_turned(Ray<T>{{-1, 1, 1}, {1, 0, 0}}, no_hit<T>);
    check_turned(Ray<T>{{-1, 1, kLeast<T>}, {1, 0, 0}}, no_hit<T>);
    check_turned(Ray<T>{{-1, 1, -kLeast<T>}, {kLeast<T>, 0, 0}}, no_hit<T>);
    check_turned(Ray<T>{{-1, -1, 0}, {1, 0, 0}}, no_hit<T>);
  });
}

TEST_CASE("A ray that leaves the plane by the least there is has one common point") {
  in_both_formats([]<Real T>() {
    const Triangle<T>& triangle = right<T>;
    check_answer(Ray<T>{{1, 1, 0}, {1, 0, kLeast<T>}}, triangle, at_point<T>(face, Facing::back, 0, T(0.25), T(0.25)));
    check_answer(Ray<T>{{-1, 1, kLeast<T>}, {1, 0, -kLeast<T>}}, triangle, at_point<T>(edge_ca, Facing::front, 1, 0, T(0.25)));
    check_answer(Ray<T>{{-1, 1, 2 * kLeast<T>}, {1, 0, -kLeast<T>}}, triangle,
                 at_point<T>(face, Facing::front, 2, T(0.25), T(0.25)));
    check_answer(Ray<T>{{-1, 1, 6 * kLeast<T>}, {1, 0, -kLeast<T>}}, triangle, triangle_miss<T>(Facing::front));
  });
}

TEST_CASE("The common part is cut to the range, and ends that are cut are the bounds themselves") {
  in_both_formats([]<Real T>() {
    const auto within = [](T t_min, T t_max) { return Ray<T>{{-1, 1, 0}, {1, 0, 0}, t_min, t_max}; };
    check_turned(within(2, 3), along<T>(coplanar, 2, 3));
    check_turned(within(2, 2), along<T>(coplanar, 2, 2));
    check_turned(within(-3, 2), along<T>(coplanar, 1, 2));
    check_turned(within(0, 1), along<T>(coplanar, 1, 1));
    check_turned(within(4, 9), along<T>(coplanar, 4, 4));
    check_turned(within(0, std::nextafter(T(1), T(0))), no_hit<T>);
    check_turned(within(std::nextafter(T(4), T(5)), kInfinity<T>), no_hit<T>);
    check_turned(within(std::nextafter(T(4), T(0)), kInfinity<T>), along<T>(coplanar, std::nextafter(T(4), T(0)), 4));
    // A cut end of -0 is answered as 0.
    check_turned(Ray<T>{{1, 1, 0}, {1, 0, 0}, T(-0.0), 9}, along<T>(coplanar, 0, 2));
    check_turned(Ray<T>{{1, 1, 0}, {1, 0, 0}, -9, T(-0.0)}, along<T>(coplanar, -1, 0));
    check_turned(Ray<T>{{1, 1, 0}, {1, 0, 0}, kLeast<T>, kLeast<T>}, along<T>(coplanar, kLeast<T>, kLeast<T>));
  });
}

TEST_CASE("Ends are compared before rounding") {
  in_both_formats([]<Real T>() {
    // From 1/3 to 4/3; the number nearest to 1/3 lies below it in double, above it in float.
    const T third = T(1) / T(3);
    const auto scaled = [](T t_min, T t_max) { return Ray<T>{{-1, 1, 0}, {3, 0, 0}, t_min, t_max}; };
    check_turned(scaled(0, kInfinity<T>), along<T>(coplanar, third, T(4) / T(3)));
    check_turned(scaled(0, third), std::same_as<T, double> ? no_hit<T> : along<T>(coplanar, third, third));
    check_turned(scaled(third, kInfinity<T>), along<T>(coplanar, third, T(4) / T(3)));
  });
}

}  // namespace
}  // namespace graze::test
