// Ray and triangle by hand: the face, each edge, each corner, what is just beside them, and the side the ray comes from.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/triangle/corners.hpp"

namespace graze::test {
namespace {

using enum TriangleKind;
using enum Facing;

/// Straight down on it from a height of 2.
template <Real T>
Ray<T> down(T x, T y) {
  return {{x, y, 2}, {0, 0, -1}};
}

TEST_CASE("The face, and the weights of its corners") {
  in_both_formats([]<Real T>() {
    check_answer(down<T>(1, 1), right<T>, at_point<T>(face, front, 2, T(0.25), T(0.25)));
    check_answer(down<T>(1, 2), right<T>, at_point<T>(face, front, 2, T(0.25), T(0.5)));
    check_answer(down<T>(T(0.5), 3), right<T>, at_point<T>(face, front, 2, T(0.125), T(0.75)));
    // From below, with a direction of length 4.
    check_answer(Ray<T>{{1, 2, -6}, {0, 0, 4}}, right<T>, at_point<T>(face, back, T(1.5), T(0.25), T(0.5)));
    // Slanting: through (1, 1, 0) at t = 2/3.
    check_answer(Ray<T>{{3, -1, 2}, {-3, 3, -3}}, right<T>, at_point<T>(face, front, T(2) / T(3), T(0.25), T(0.25)));
    // Weights of a third.
    check_answer(Ray<T>{{1, 1, 1}, {0, 0, -1}}, Triangle<T>{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}},
                 at_point<T>(face, front, 1, T(1) / T(3), T(1) / T(3)));
  });
}

TEST_CASE("Each edge, where it is met inside") {
  in_both_formats([]<Real T>() {
    check_answer(down<T>(1, 0), right<T>, at_point<T>(edge_ab, front, 2, T(0.25), 0));
    check_answer(down<T>(3, 1), right<T>, at_point<T>(edge_bc, front, 2, T(0.75), T(0.25)));
    check_answer(down<T>(1, 3), right<T>, at_point<T>(edge_bc, front, 2, T(0.25), T(0.75)));
    check_answer(down<T>(0, 3), right<T>, at_point<T>(edge_ca, front, 2, 0, T(0.75)));
  });
}

TEST_CASE("Each corner") {
  in_both_formats([]<Real T>() {
    check_answer(down<T>(0, 0), right<T>, at_point<T>(vertex_a, front, 2, 0, 0));
    check_answer(down<T>(4, 0), right<T>, at_point<T>(vertex_b, front, 2, 1, 0));
    check_answer(down<T>(0, 4), right<T>, at_point<T>(vertex_c, front, 2, 0, 1));
    check_answer(down<T>(T(-0.0), T(-0.0)), right<T>, at_point<T>(vertex_a, front, 2, 0, 0));
  });
}

TEST_CASE("Beside an edge, by the least there is") {
  in_both_formats([]<Real T>() {
    const T least = kLeast<T>, one_more = std::nextafter(T(1), T(2)), one_less = std::nextafter(T(1), T(0));
    check_answer(down<T>(1, -least), right<T>, triangle_miss<T>(front));
    check_answer(down<T>(-least, 1), right<T>, triangle_miss<T>(front));
    check_answer(down<T>(3, one_more), right<T>, triangle_miss<T>(front));
    check_answer(down<T>(-least, -least), right<T>, triangle_miss<T>(front));
    // And on the inner side: u and v are rounded, the kind is not.
    check_answer(down<T>(1, least), right<T>, at_point<T>(face, front, 2, T(0.25), 0));
    check_answer(down<T>(least, 1), right<T>, at_point<T>(face, front, 2, 0, T(0.25)));
    check_answer(down<T>(4 * least, 1), right<T>, at_point<T>(face, front, 2, least, T(0.25)));
    check_answer(down<T>(3, one_less), right<T>, at_point<T>(face, front, 2, T(0.75), one_less / 4));
    check_answer(down<T>(3, T(1)), right<T>, at_point<T>(edge_bc, front, 2, T(0.75), T(0.25)));
  });
}

TEST_CASE("The slip 1 - u < u, and v tested alone, would each lose or add hits") {
  in_both_formats([]<Real T>() {
    // u = 3/4 is inside while 1 - u < u; v = 3/4 with u = 1/2 is outside while v < 1.
    check_answer(down<T>(3, T(0.5)), right<T>, at_point<T>(face, front, 2, T(0.75), T(0.125)));
    check_answer(down<T>(2, 3), right<T>, triangle_miss<T>(front));
  });
}

TEST_CASE("The side the ray comes from, told for a miss too") {
  in_both_formats([]<Real T>() {
    const Triangle<T> turned{right<T>.a, right<T>.c, right<T>.b};
    check_answer(down<T>(1, 2), turned, at_point<T>(face, back, 2, T(0.5), T(0.25)));
    check_answer(down<T>(9, 9), right<T>, triangle_miss<T>(front));
    check_answer(down<T>(9, 9), turned, triangle_miss<T>(back));
    // Away from the triangle: before its origin, still from the front.
    check_answer(Ray<T>{{1, 1, -2}, {0, 0, -1}}, right<T>, triangle_miss<T>(front));
    check_answer(Ray<T>{{1, 1, 2}, {0, 0, 1}}, right<T>, triangle_miss<T>(back));
    // Along the plane, beside it.
    check_answer(Ray<T>{{1, 1, 2}, {1, 0, 0}}, right<T>, triangle_miss<T>(none));
  });
}

TEST_CASE("An origin on the triangle is met at zero") {
  in_both_formats([]<Real T>() {
    for (const int side : {-1, 1}) {
      const Facing facing = side < 0 ? front : back;
      check_answer(Ray<T>{{1, 1, 0}, {0, 0, T(side)}}, right<T>, at_point<T>(face, facing, 0, T(0.25), T(0.25)));
      check_answer(Ray<T>{{4, 0, 0}, {1, 1, T(side)}}, right<T>, at_point<T>(vertex_b, facing, 0, 1, 0));
    }
  });
}

TEST_CASE("Of two triangles with a common edge, a ray through it meets both, beside it one") {
  in_both_formats([]<Real T>() {
    const Triangle<T> first{{0, 0, 0}, {1, 0, 0}, {T(0.1), T(0.7), T(0.3)}},
        second{{1, 0, 0}, {0, 0, 0}, {T(0.2), T(-0.9), T(0.3)}};
    for (const T x : {T(0.1), T(0.5), T(0.7), T(0.9)}) {
      CHECK(intersect(down<T>(x, 0), first).kind == edge_ab);
      CHECK(intersect(down<T>(x, 0), second).kind == edge_ab);
      CHECK(hits(down<T>(x, kLeast<T>), first));
      CHECK(!hits(down<T>(x, kLeast<T>), second));
      CHECK(!hits(down<T>(x, -kLeast<T>), first));
      CHECK(hits(down<T>(x, -kLeast<T>), second));
    }
  });
}

}  // namespace
}  // namespace graze::test
