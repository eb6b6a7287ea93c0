// Invalid input: the first reason in the contract's order, and nothing else in the answer.
#include <array>

#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

template <Real T>
const Ray<T> kRay{{0, 0, 0}, {1, 0, 0}};
template <Real T>
const Sphere<T> kSphere{{5, 0, 0}, 1};
template <Real T>
const Triangle<T> kTriangle{{5, 0, 0}, {5, 1, 0}, {5, 0, 1}};

/// Each coordinate of a shape in turn.
template <Real T>
[[nodiscard]] auto coordinates(Vec3<T>& v) {
  return std::array<T*, 3>{&v.x, &v.y, &v.z};
}

TEST_CASE("No coordinate may be infinite or NaN") {
  everywhere([]<Real T>(const Oracle& oracle) {
    for (const T bad :
         {kInfinity<T>, -kInfinity<T>, std::numeric_limits<T>::quiet_NaN(), -std::numeric_limits<T>::quiet_NaN()}) {
      CAPTURE(bad);
      for (std::size_t i = 0; i < 3; ++i) {
        for (Vec3<T> Ray<T>::*part : {&Ray<T>::origin, &Ray<T>::direction}) {
          Ray<T> ray = kRay<T>;
          *coordinates(ray.*part)[i] = bad;
          CHECK(oracle.answer(ray, kSphere<T>) == invalid_sphere<T>(Status::non_finite));
          CHECK(oracle.answer(ray, kTriangle<T>) == invalid_triangle<T>(Status::non_finite));
        }
        Sphere<T> sphere = kSphere<T>;
        *coordinates(sphere.center)[i] = bad;
        CHECK(oracle.answer(kRay<T>, sphere) == invalid_sphere<T>(Status::non_finite));
        for (Vec3<T> Triangle<T>::*corner : {&Triangle<T>::a, &Triangle<T>::b, &Triangle<T>::c}) {
          Triangle<T> triangle = kTriangle<T>;
          *coordinates(triangle.*corner)[i] = bad;
          CHECK(oracle.answer(kRay<T>, triangle) == invalid_triangle<T>(Status::non_finite));
        }
      }
      CHECK(oracle.answer(kRay<T>, Sphere<T>{{5, 0, 0}, bad}) == invalid_sphere<T>(Status::non_finite));
      const Ray<T> bad_start{{0, 0, 0}, {1, 0, 0}, bad};
      CHECK(oracle.answer(bad_start, kSphere<T>) == invalid_sphere<T>(Status::non_finite));
      CHECK(oracle.answer(bad_start, kTriangle<T>) == invalid_triangle<T>(Status::non_finite));
      const Ray<T> bad_end{{0, 0, 0}, {1, 0, 0}, 0, bad};
      const bool allowed = bad == kInfinity<T>;
      CHECK(oracle.answer(bad_end, kSphere<T>).status == (allowed ? Status::ok : Status::non_finite));
      CHECK(oracle.answer(bad_end, kTriangle<T>).status == (allowed ? Status::ok : Status::non_finite));
    }
  });
}

TEST_CASE("The first reason in the order is told") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const Ray<T> no_direction{{0, 0, 0}, {0, T(-0.0), 0}, 2, 1};
    const Ray<T> no_range{{0, 0, 0}, {1, 0, 0}, 2, 1};
    const Sphere<T> negative{{0, 0, 0}, -kLeast<T>};
    CHECK(oracle.answer(no_direction, Sphere<T>{{nan, 0, 0}, -1}) == invalid_sphere<T>(Status::non_finite));
    CHECK(oracle.answer(no_direction, negative) == invalid_sphere<T>(Status::zero_direction));
    CHECK(oracle.answer(no_range, negative) == invalid_sphere<T>(Status::negative_radius));
    CHECK(oracle.answer(no_range, kSphere<T>) == invalid_sphere<T>(Status::empty_range));
    CHECK(oracle.answer(no_direction, Triangle<T>{{0, 0, 0}, {0, 0, 0}, {0, 0, nan}}) ==
          invalid_triangle<T>(Status::non_finite));
    CHECK(oracle.answer(no_direction, kTriangle<T>) == invalid_triangle<T>(Status::zero_direction));
    CHECK(oracle.answer(no_range, kTriangle<T>) == invalid_triangle<T>(Status::empty_range));
  });
}

TEST_CASE("A direction of one least number is a direction, a range of one point is a range, -0 is 0") {
  everywhere([]<Real T>(const Oracle& oracle) {
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {0, 0, kLeast<T>}}, kSphere<T>).status == Status::ok);
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 4, 4}, kSphere<T>).kind == SphereKind::secant);
    CHECK(oracle.answer(Ray<T>{{4, 0, 0}, {1, 0, 0}, T(0.0), T(-0.0)}, kSphere<T>).kind == SphereKind::secant);
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, kLeast<T>, T(0)}, kSphere<T>).status == Status::empty_range);
  });
}

TEST_CASE("An invalid input has no truth") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> no_direction{};
    CHECK(oracle.truth(no_direction, kSphere<T>).hit == invalid_sphere<T>(Status::zero_direction));
    CHECK(oracle.truth(no_direction, kTriangle<T>).hit == invalid_triangle<T>(Status::zero_direction));
  });
}

}  // namespace
}  // namespace graze::oracle
