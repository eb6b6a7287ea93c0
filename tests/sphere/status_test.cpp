// Ray and sphere: invalid and hostile input.
#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/hostile.hpp"

namespace graze::test {
namespace {

TEST_CASE("Ray and sphere: the first reason in the order is told, and nothing else") {
  in_both_formats([]<Real T>() {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}}, no_direction{{0, 0, 0}, {0, T(-0.0), 0}, 2, 1},
        no_range{{0, 0, 0}, {1, 0, 0}, 2, 1};
    const Sphere<T> sphere{{5, 0, 0}, 1}, negative{{5, 0, 0}, -1}, broken{{nan, 0, 0}, -1};
    check_answer(no_direction, broken, invalid_sphere<T>(Status::non_finite));
    check_answer(no_direction, negative, invalid_sphere<T>(Status::zero_direction));
    check_answer(no_range, negative, invalid_sphere<T>(Status::negative_radius));
    check_answer(no_range, sphere, invalid_sphere<T>(Status::empty_range));
    check_answer(ray, sphere, secant<T>(OriginSide::outside, 4, 6));
  });
}

TEST_CASE("Ray and sphere: the least of each is enough") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{5, 0, 0}, 1};
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{5, 0, 0}, -kLeast<T>}, invalid_sphere<T>(Status::negative_radius));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{5, 0, 0}, T(-0.0)}, tangent<T>(OriginSide::outside, 5));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, kLeast<T>, 0}, sphere, invalid_sphere<T>(Status::empty_range));
    check_answer(Ray<T>{{4, 0, 0}, {1, 0, 0}, T(0.0), T(-0.0)}, sphere, lone<T>(OriginSide::on, Root::first, 0));
    check_answer(Ray<T>{{0, 0, 0}, {-kLeast<T>, 0, 0}}, sphere, sphere_miss<T>(OriginSide::outside));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 0, -kInfinity<T>}, sphere, invalid_sphere<T>(Status::non_finite));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, -kInfinity<T>, 0}, sphere, invalid_sphere<T>(Status::non_finite));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, kInfinity<T>, kInfinity<T>}, sphere, invalid_sphere<T>(Status::non_finite));
  });
}

TEST_CASE("Ray and sphere: one or two hostile numbers, at every place") {
  in_both_formats([]<Real T>() {
    require_hostile_agreement<T>(fuzz::RaySphere<T>{{{0, T(0.25), 0}, {1, 0, T(0.5)}}, {{3, 1, 2}, 2}});
    require_hostile_agreement<T>(fuzz::RaySphere<T>{{{0, 0, 0}, {0, 0, 1}, 1, 3}, {{0, 0, 3}, 2}});
  });
}

}  // namespace
}  // namespace graze::test
