// Triangles without area, computed by hand.
#include <algorithm>

#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

using enum TriangleKind;

/// Every order of the corners is the same set of points.
template <Real T>
void check(const Oracle& oracle, const Ray<T>& ray, const Triangle<T>& triangle, const TriangleHit<T>& expected) {
  const Vec3<T> p[] = {triangle.a, triangle.b, triangle.c};
  int order[] = {0, 1, 2};
  do {
    CHECK(oracle.answer(ray, Triangle<T>{p[order[0]], p[order[1]], p[order[2]]}) == expected);
  } while (std::next_permutation(order, order + 3));
}

TEST_CASE("A segment across the ray") {
  everywhere([]<Real T>(const Oracle& oracle) {
    for (const Triangle<T>& segment :
         {Triangle<T>{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, Triangle<T>{{0, 0, 0}, {0, 0, 0}, {4, 0, 0}}}) {
      check(oracle, Ray<T>{{1, -2, 0}, {0, 1, 0}}, segment, along<T>(degenerate, 2, 2));
      check(oracle, Ray<T>{{4, -2, 0}, {0, 1, 0}}, segment, along<T>(degenerate, 2, 2));
      check(oracle, Ray<T>{{2, -1, 0}, {0, 3, 0}}, segment, along<T>(degenerate, T(1) / T(3), T(1) / T(3)));
      check(oracle, Ray<T>{{3, 3, 3}, {-1, -1, -1}}, segment, along<T>(degenerate, 3, 3));
      check(oracle, Ray<T>{{5, -2, 0}, {0, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{-1, -2, 0}, {0, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{1, -2, kLeast<T>}, {0, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{1, 2, 0}, {0, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{1, 2, 0}, {0, 1, 0}, -2, 0}, segment, along<T>(degenerate, -2, -2));
    }
  });
}

TEST_CASE("A segment along the ray") {
  everywhere([]<Real T>(const Oracle& oracle) {
    for (const Triangle<T>& segment :
         {Triangle<T>{{0, 0, 0}, {2, 2, 0}, {4, 4, 0}}, Triangle<T>{{0, 0, 0}, {4, 4, 0}, {4, 4, 0}}}) {
      check(oracle, Ray<T>{{-1, -1, 0}, {1, 1, 0}}, segment, along<T>(degenerate, 1, 5));
      check(oracle, Ray<T>{{-1, -1, 0}, {1, 1, 0}, 2, 3}, segment, along<T>(degenerate, 2, 3));
      check(oracle, Ray<T>{{5, 5, 0}, {-2, -2, 0}}, segment, along<T>(degenerate, T(0.5), T(2.5)));
      check(oracle, Ray<T>{{1, 1, 0}, {1, 1, 0}}, segment, along<T>(degenerate, 0, 3));
      check(oracle, Ray<T>{{4, 4, 0}, {1, 1, 0}}, segment, along<T>(degenerate, 0, 0));
      check(oracle, Ray<T>{{5, 5, 0}, {1, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{0, 1, 0}, {1, 1, 0}}, segment, triangle_miss<T>(Facing::none));
      check(oracle, Ray<T>{{-1, -1, 0}, {1, 1, 0}, 6, 6}, segment, triangle_miss<T>(Facing::none));
    }
  });
}

TEST_CASE("A point") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Triangle<T> point{{2, 4, 6}, {2, 4, 6}, {2, 4, 6}};
    check(oracle, Ray<T>{{0, 0, 0}, {1, 2, 3}}, point, along<T>(degenerate, 2, 2));
    check(oracle, Ray<T>{{2, 4, 6}, {1, 2, 3}}, point, along<T>(degenerate, 0, 0));
    check(oracle, Ray<T>{{3, 6, 9}, {1, 2, 3}}, point, triangle_miss<T>(Facing::none));
    check(oracle, Ray<T>{{0, 0, 0}, {1, 2, 4}}, point, triangle_miss<T>(Facing::none));
    check(oracle, Ray<T>{{0, 0, 0}, {1, 2, 3}, 2, 2}, point, along<T>(degenerate, 2, 2));
    check(oracle, Ray<T>{{0, 0, 0}, {1, 2, 3}, 0, 1}, point, triangle_miss<T>(Facing::none));
  });
}

TEST_CASE("One ulp of area is area") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Triangle<T> thin{{0, 0, 0}, {2, kLeast<T>, 0}, {4, 0, 0}};
    CHECK(oracle.answer(Ray<T>{{1, -2, 0}, {0, 1, 0}}, thin).kind == coplanar);
    CHECK(oracle.answer(Ray<T>{{2, 0, -2}, {0, 0, 1}}, thin).kind == edge_ca);
  });
}

}  // namespace
}  // namespace graze::oracle
