// Triangles without area, by hand: segments and points, in every order of their corners.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/triangle/corners.hpp"

namespace graze::test {
namespace {

using enum TriangleKind;

/// All six orders of the corners.
template <Real T>
void check_all_orders(const Ray<T>& ray, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, const TriangleHit<T>& expected) {
  for (const Triangle<T>& triangle : all_orders(Triangle<T>{a, b, c})) {
    check_answer(ray, triangle, expected);
  }
}

template <Real T>
const TriangleHit<T> no_hit = triangle_miss<T>(Facing::none);

TEST_CASE("A point") {
  in_both_formats([]<Real T>() {
    const Vec3<T> p{3, 0, 0};
    check_all_orders(Ray<T>{{0, 0, 0}, {2, 0, 0}}, p, p, p, along<T>(degenerate, T(1.5), T(1.5)));
    check_all_orders(Ray<T>{{3, 0, 0}, {0, 1, 0}}, p, p, p, along<T>(degenerate, 0, 0));
    check_all_orders(Ray<T>{{0, kLeast<T>, 0}, {2, 0, 0}}, p, p, p, no_hit<T>);
    check_all_orders(Ray<T>{{0, 0, 0}, {-1, 0, 0}}, p, p, p, no_hit<T>);
    check_all_orders(Ray<T>{{0, 0, 0}, {-3, 0, 0}, -1}, p, p, p, along<T>(degenerate, -1, -1));
    check_all_orders(Ray<T>{{0, 0, 0}, {-3, 0, 0}, std::nextafter(T(-1), T(0))}, p, p, p, no_hit<T>);
    check_all_orders(Ray<T>{{0, 0, 0}, {1, 2, 3}}, {}, {}, {}, along<T>(degenerate, 0, 0));
  });
}

TEST_CASE("A segment that is crossed") {
  in_both_formats([]<Real T>() {
    const Vec3<T> p{0, 0, 0}, middle{1, 1, 0}, q{4, 4, 0};
    for (const Vec3<T>& third : {p, middle, q}) {
      check_all_orders(Ray<T>{{2, 2, 3}, {0, 0, -2}}, p, q, third, along<T>(degenerate, T(1.5), T(1.5)));
      check_all_orders(Ray<T>{{4, 4, 1}, {0, 0, -1}}, p, q, third, along<T>(degenerate, 1, 1));
      check_all_orders(Ray<T>{{0, 0, 1}, {0, 0, -1}}, p, q, third, along<T>(degenerate, 1, 1));
      check_all_orders(Ray<T>{{2, std::nextafter(T(2), T(3)), 3}, {0, 0, -2}}, p, q, third, no_hit<T>);
      check_all_orders(Ray<T>{{-kLeast<T>, -kLeast<T>, 1}, {0, 0, -1}}, p, q, third, no_hit<T>);
      check_all_orders(Ray<T>{{5, 5, 1}, {0, 0, -1}}, p, q, third, no_hit<T>);
      // In a plane with it, from one side and from the other.
      check_all_orders(Ray<T>{{0, 3, 0}, {3, 0, 0}}, p, q, third, along<T>(degenerate, 1, 1));
      check_all_orders(Ray<T>{{6, 3, 0}, {-1, 0, 0}}, p, q, third, along<T>(degenerate, 3, 3));
      check_all_orders(Ray<T>{{0, 1, 0}, {-1, 0, 0}}, p, q, third, no_hit<T>);
    }
  });
}

TEST_CASE("A segment along the ray") {
  in_both_formats([]<Real T>() {
    const Vec3<T> p{1, 2, 2}, q{4, 8, 8}, middle{2, 4, 4}, d{1, 2, 2};
    for (const Vec3<T>& third : {p, middle, q}) {
      check_all_orders(Ray<T>{{0, 0, 0}, d}, p, q, third, along<T>(degenerate, 1, 4));
      check_all_orders(Ray<T>{{2, 4, 4}, d}, p, q, third, along<T>(degenerate, 0, 2));
      check_all_orders(Ray<T>{{5, 10, 10}, d}, p, q, third, no_hit<T>);
      check_all_orders(Ray<T>{{4, 8, 8}, d}, p, q, third, along<T>(degenerate, 0, 0));
      check_all_orders(Ray<T>{{5, 10, 10}, {-3, -6, -6}}, p, q, third, along<T>(degenerate, T(1) / T(3), T(4) / T(3)));
      check_all_orders(Ray<T>{{0, 0, 0}, d, 2, 3}, p, q, third, along<T>(degenerate, 2, 3));
      check_all_orders(Ray<T>{{0, 0, 0}, d, 4, 9}, p, q, third, along<T>(degenerate, 4, 4));
      check_all_orders(Ray<T>{{0, 0, 0}, d, std::nextafter(T(4), T(5)), 9}, p, q, third, no_hit<T>);
      // Parallel, beside it.
      check_all_orders(Ray<T>{{0, 0, kLeast<T>}, d}, p, q, third, no_hit<T>);
    }
  });
}

TEST_CASE("Collinear or not is decided exactly") {
  in_both_formats([]<Real T>() {
    // Three corners on a line of slope 1/3 but for one ulp.
    const T x = T(3), y = T(1);
    const Triangle<T> flat{{0, 0, 0}, {x, y, 0}, {2 * x, 2 * y, 0}},
        bent{{0, 0, 0}, {x, std::nextafter(y, T(2)), 0}, {2 * x, 2 * y, 0}};
    const Ray<T> through_b{{x, y, 1}, {0, 0, -1}};
    check_answer(through_b, flat, along<T>(degenerate, 1, 1));
    CHECK(intersect(through_b, bent).kind == edge_ca);
    CHECK(intersect(through_b, bent).facing == Facing::back);
    // A normal that would underflow: the area of a triangle of the least numbers.
    const T least = kLeast<T>;
    check_answer(Ray<T>{{least, least, 1}, {0, 0, -1}}, Triangle<T>{{0, 0, 0}, {4 * least, 0, 0}, {0, 4 * least, 0}},
                 at_point<T>(face, Facing::front, 1, T(0.25), T(0.25)));
  });
}

}  // namespace
}  // namespace graze::test
