// Ray and triangle: invalid and hostile input.
#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/hostile.hpp"

namespace graze::test {
namespace {

TEST_CASE("Ray and triangle: the first reason in the order is told, and nothing else") {
  in_both_formats([]<Real T>() {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const Ray<T> no_direction{{0, 0, 0}, {0, T(-0.0), 0}, 2, 1}, no_range{{0, 0, 0}, {1, 0, 0}, 2, 1};
    const Triangle<T> triangle{{5, 0, 0}, {5, 1, 0}, {5, 0, 1}}, broken{{0, 0, 0}, {0, 0, 0}, {0, 0, nan}}, point{};
    check_answer(no_direction, broken, invalid_triangle<T>(Status::non_finite));
    check_answer(no_direction, triangle, invalid_triangle<T>(Status::zero_direction));
    check_answer(no_range, triangle, invalid_triangle<T>(Status::empty_range));
    check_answer(no_range, point, invalid_triangle<T>(Status::empty_range));
    // An infinite corner, whichever way the filter would have gone.
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Triangle<T>{{5, 0, 0}, {5, kInfinity<T>, 0}, {5, 0, 1}},
                 invalid_triangle<T>(Status::non_finite));
  });
}

TEST_CASE("Ray and triangle: the least of each is enough") {
  in_both_formats([]<Real T>() {
    const Triangle<T> triangle{{5, -1, -1}, {5, 3, -1}, {5, -1, 3}};
    const auto hit = at_point<T>(TriangleKind::face, Facing::back, 5, T(0.25), T(0.25));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, triangle, hit);
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, kLeast<T>, 0}, triangle, invalid_triangle<T>(Status::empty_range));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 5, 5}, triangle, hit);
    check_answer(Ray<T>{{0, 0, 0}, {-kLeast<T>, 0, 0}}, triangle, triangle_miss<T>(Facing::front));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 0, -kInfinity<T>}, triangle, invalid_triangle<T>(Status::non_finite));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, -kInfinity<T>, 0}, triangle, invalid_triangle<T>(Status::non_finite));
  });
}

TEST_CASE("Ray and triangle: one or two hostile numbers, at every place") {
  in_both_formats([]<Real T>() {
    require_hostile_agreement<T>(
        fuzz::RayTriangle<T>{{{0, T(0.25), 0}, {1, 0, T(0.5)}}, {{3, -1, -1}, {3, 4, -1}, {4, -1, 5}}});
    require_hostile_agreement<T>(fuzz::RayTriangle<T>{{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}});
  });
}

}  // namespace
}  // namespace graze::test
