// A ray in the plane of a triangle, or parallel to it, computed by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

using enum TriangleKind;

template <Real T>
const Triangle<T> kRight{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

/// The same question with the axes turned, so that each of them is once the one to project along.
template <Real T>
[[nodiscard]] TriangleHit<T> answer_turned(const Oracle& oracle, const Ray<T>& ray, int turns) {
  const auto turned = [turns](Vec3<T> v) {
    for (int i = 0; i < turns; ++i) v = {v.z, v.x, v.y};
    return v;
  };
  const Triangle<T> triangle{turned(kRight<T>.a), turned(kRight<T>.b), turned(kRight<T>.c)};
  const Triangle<T> reversed{triangle.a, triangle.c, triangle.b};
  const Ray<T> turned_ray{turned(ray.origin), turned(ray.direction), ray.t_min, ray.t_max};
  const TriangleHit<T> hit = oracle.answer(turned_ray, triangle);
  CHECK(hit == oracle.answer(turned_ray, reversed));
  return hit;
}

template <Real T>
void check(const Oracle& oracle, const Ray<T>& ray, const TriangleHit<T>& expected) {
  for (int turns : {0, 1, 2}) CHECK(answer_turned(oracle, ray, turns) == expected);
}

TEST_CASE("A coplanar ray that crosses") {
  everywhere([]<Real T>(const Oracle& oracle) {
    check(oracle, Ray<T>{{-1, 1, 0}, {1, 0, 0}}, along<T>(coplanar, 1, 4));
    check(oracle, Ray<T>{{1, 1, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 2));
    check(oracle, Ray<T>{{1, 1, 0}, {2, 2, 0}}, along<T>(coplanar, 0, T(0.5)));
    check(oracle, Ray<T>{{-1, -1, 0}, {1, 1, 0}}, along<T>(coplanar, 1, 3));
    check(oracle, Ray<T>{{5, 1, 0}, {1, 0, 0}}, triangle_miss<T>(Facing::none));
  });
}

TEST_CASE("A coplanar ray that touches a corner") {
  everywhere([]<Real T>(const Oracle& oracle) {
    check(oracle, Ray<T>{{4, -1, 0}, {0, 1, 0}}, along<T>(coplanar, 1, 1));
    check(oracle, Ray<T>{{-2, 2, 0}, {1, -1, 0}}, along<T>(coplanar, 2, 2));
    check(oracle, Ray<T>{{4, 1, 0}, {0, 1, 0}}, triangle_miss<T>(Facing::none));
    check(oracle, Ray<T>{{std::nextafter(T(4), T(5)), -1, 0}, {0, 1, 0}}, triangle_miss<T>(Facing::none));
  });
}

TEST_CASE("A coplanar ray on an edge's line") {
  everywhere([]<Real T>(const Oracle& oracle) {
    // Toward the edge, on it, at its end, away from it.
    check(oracle, Ray<T>{{-1, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 1, 5));
    check(oracle, Ray<T>{{1, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 3));
    check(oracle, Ray<T>{{4, 0, 0}, {1, 0, 0}}, along<T>(coplanar, 0, 0));
    check(oracle, Ray<T>{{5, 0, 0}, {1, 0, 0}}, triangle_miss<T>(Facing::none));
    // The same on the hypotenuse.
    check(oracle, Ray<T>{{5, -1, 0}, {-1, 1, 0}}, along<T>(coplanar, 1, 5));
    check(oracle, Ray<T>{{-1, 5, 0}, {-1, 1, 0}}, triangle_miss<T>(Facing::none));
  });
}

TEST_CASE("A parallel ray off the plane misses, by however little") {
  everywhere([]<Real T>(const Oracle& oracle) {
    check(oracle, Ray<T>{{-1, 1, 1}, {1, 0, 0}}, triangle_miss<T>(Facing::none));
    check(oracle, Ray<T>{{-1, 1, kLeast<T>}, {1, 0, 0}}, triangle_miss<T>(Facing::none));
    check(oracle, Ray<T>{{-1, -1, 0}, {1, 0, 0}}, triangle_miss<T>(Facing::none));
  });
}

TEST_CASE("The common part is cut to the range, and cut ends are the bounds themselves") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const auto within = [](T t_min, T t_max) { return Ray<T>{{-1, 1, 0}, {1, 0, 0}, t_min, t_max}; };
    check(oracle, within(2, 3), along<T>(coplanar, 2, 3));
    check(oracle, within(2, 2), along<T>(coplanar, 2, 2));
    check(oracle, within(-3, 2), along<T>(coplanar, 1, 2));
    check(oracle, within(0, 1), along<T>(coplanar, 1, 1));
    check(oracle, within(4, 9), along<T>(coplanar, 4, 4));
    check(oracle, within(0, T(0.5)), triangle_miss<T>(Facing::none));
    check(oracle, within(5, 6), triangle_miss<T>(Facing::none));
    // From 1/3 to 4/3: whether the bound that prints as 1/3 reaches it is decided before rounding.
    const T third = T(1) / T(3);
    const auto scaled = [](T t_min, T t_max) { return Ray<T>{{-1, 1, 0}, {3, 0, 0}, t_min, t_max}; };
    check(oracle, scaled(0, kInfinity<T>), along<T>(coplanar, third, T(4) / T(3)));
    check(oracle, scaled(0, third),
          std::same_as<T, double> ? triangle_miss<T>(Facing::none) : along<T>(coplanar, third, third));
  });
}

TEST_CASE("The truth of a coplanar ray tells both ends") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const TriangleTruth<T> truth = oracle.truth(Ray<T>{{-1, 1, 0}, {3, 0, 0}, 0, T(0.75)}, kRight<T>);
    CHECK(truth.t.rational == mpq_class(1, 3));
    CHECK(truth.t_end.rational == mpq_class(3, 4));
  });
}

}  // namespace
}  // namespace graze::oracle
