// Ray and sphere by hand: every kind, every side of the origin, every root.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using enum OriginSide;

TEST_CASE("The discriminant has three cases") {
  in_both_formats([]<Real T>() {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    check_answer(ray, Sphere<T>{{5, 0, 0}, 1}, secant<T>(outside, 4, 6));
    check_answer(ray, Sphere<T>{{5, 1, 0}, 1}, tangent<T>(outside, 5));
    check_answer(ray, Sphere<T>{{5, 2, 0}, 1}, sphere_miss<T>(outside));
    // One ulp to either side of the tangent.
    CHECK(intersect(ray, Sphere<T>{{5, std::nextafter(T(1), T(2)), 0}, 1}).kind == SphereKind::miss);
    CHECK(intersect(ray, Sphere<T>{{5, std::nextafter(T(1), T(0)), 0}, 1}).kind == SphereKind::secant);
    CHECK(intersect(ray, Sphere<T>{{5, 1, kLeast<T>}, 1}).kind == SphereKind::miss);
    CHECK(intersect(ray, Sphere<T>{{5, 1, 0}, std::nextafter(T(1), T(2))}).kind == SphereKind::secant);
  });
}

TEST_CASE("A tangent may touch where no number is") {
  in_both_formats([]<Real T>() {
    check_answer(Ray<T>{{0, 0, 0}, {1, 2, 2}}, Sphere<T>{{1, 1, 0}, 1}, tangent<T>(outside, T(1) / T(3)));
    check_answer(Ray<T>{{0, 0, 0}, {-1, -2, -2}, -1}, Sphere<T>{{1, 1, 0}, 1}, tangent<T>(outside, T(-1) / T(3)));
    // 1/9 from the orthogonal rows (1 2 2), (2 1 -2) of length 3: the center is d / 9 away from the line by (2 1 -2) / 9.
    check_answer(Ray<T>{{0, 0, 0}, {9, 18, 18}}, Sphere<T>{{3, 3, 0}, 3}, tangent<T>(outside, T(1) / T(9)));
  });
}

TEST_CASE("The origin inside, on and outside") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{2, 0, 0}, 2};
    check_answer(Ray<T>{{1, 0, 0}, {1, 0, 0}}, sphere, lone<T>(inside, Root::second, 3));
    check_answer(Ray<T>{{2, 0, 0}, {0, 4, 0}}, sphere, lone<T>(inside, Root::second, T(0.5)));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, sphere, secant<T>(on, 0, 4));
    check_answer(Ray<T>{{0, 0, 0}, {-1, 0, 0}}, sphere, lone<T>(on, Root::second, 0));
    check_answer(Ray<T>{{0, 0, 0}, {0, 1, 0}}, sphere, tangent<T>(on, 0));
    check_answer(Ray<T>{{-1, 0, 0}, {-1, 0, 0}}, sphere, sphere_miss<T>(outside));
    CHECK(intersect(Ray<T>{{kLeast<T>, 0, 0}, {-1, 0, 0}}, sphere).origin == inside);
    CHECK(intersect(Ray<T>{{-kLeast<T>, 0, 0}, {-1, 0, 0}}, sphere).origin == outside);
  });
}

TEST_CASE("B = 0: the origin is the point of the line that is closest to the center") {
  in_both_formats([]<Real T>() {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}}, both_ways{{0, 0, 0}, {1, 0, 0}, -10, 10};
    check_answer(ray, Sphere<T>{{0, 0, 0}, 2}, lone<T>(inside, Root::second, 2));
    check_answer(ray, Sphere<T>{{0, 3, 0}, 5}, lone<T>(inside, Root::second, 4));
    check_answer(ray, Sphere<T>{{0, 2, 0}, 2}, tangent<T>(on, 0));
    check_answer(ray, Sphere<T>{{0, 3, 0}, 2}, sphere_miss<T>(outside));
    check_answer(both_ways, Sphere<T>{{0, 0, 0}, 2}, secant<T>(inside, -2, 2));
    check_answer(both_ways, Sphere<T>{{0, 0, 3}, 5}, secant<T>(inside, -4, 4));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, -10, 0}, Sphere<T>{{0, 0, 0}, 2}, lone<T>(inside, Root::first, -2));
  });
}

TEST_CASE("A sphere of radius zero is a point") {
  in_both_formats([]<Real T>() {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    check_answer(ray, Sphere<T>{{3, 0, 0}, 0}, tangent<T>(outside, 3));
    check_answer(ray, Sphere<T>{{3, kLeast<T>, 0}, 0}, sphere_miss<T>(outside));
    check_answer(ray, Sphere<T>{{0, 0, 0}, T(-0.0)}, tangent<T>(on, 0));
    check_answer(ray, Sphere<T>{{-1, 0, 0}, 0}, sphere_miss<T>(outside));
  });
}

TEST_CASE("Minus zero is zero, and zero is answered without a sign") {
  in_both_formats([]<Real T>() {
    const T zero = T(-0.0);
    check_answer(Ray<T>{{zero, zero, zero}, {1, zero, zero}, zero}, Sphere<T>{{5, zero, zero}, 1}, secant<T>(outside, 4, 6));
    check_answer(Ray<T>{{zero, 0, 0}, {-1, 0, zero}}, Sphere<T>{{2, 0, 0}, 2}, lone<T>(on, Root::second, 0));
    check_answer(Ray<T>{{0, 0, zero}, {-1, 0, 0}, zero, zero}, Sphere<T>{{0, zero, 0}, 0}, tangent<T>(on, 0));
    // The root 0 of C = 0, from either side of B.
    check_answer(Ray<T>{{0, 0, 0}, {-1, 0, 0}, -5, 0}, Sphere<T>{{2, 0, 0}, 2}, secant<T>(on, -4, 0));
  });
}

TEST_CASE("A root that is lost beside B^2 is found") {
  in_both_formats([]<Real T>() {
    // Roots 1 and 2 c - 1 of a sphere around c with radius c - 1.
    const T c = 1 / std::numeric_limits<T>::epsilon();
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{c, 0, 0}, c - 1}, secant<T>(outside, 1, 2 * c - 1));
    // C = s^2, B = 1: the small root s^2 / (1 + sqrt(1 - s^2)), the nearest number to which is s^2 / 2.
    const T s = std::numeric_limits<T>::epsilon() / 2;
    check_answer(Ray<T>{{0, s, 0}, {1, 0, 0}}, Sphere<T>{{1, 0, 0}, 1}, secant<T>(outside, s * s / 2, 2));
    check_answer(Ray<T>{{0, s, 0}, {-1, 0, 0}, -9}, Sphere<T>{{1, 0, 0}, 1}, secant<T>(outside, -2, -s * s / 2));
  });
}

TEST_CASE("A near zero: the direction's length changes t and nothing else") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{5, 0, 0}, 1};
    for (int k = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;
         k < std::numeric_limits<T>::max_exponent; ++k) {
      const T size = std::ldexp(T(1), k);
      CAPTURE(k);
      check_answer(Ray<T>{{0, 0, 0}, {size, 0, 0}}, sphere, secant<T>(outside, 4 / size, 6 / size));
    }
  });
}

}  // namespace
}  // namespace graze::test
