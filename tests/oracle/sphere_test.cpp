// Ray and sphere, computed by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

using enum OriginSide;

TEST_CASE("The discriminant has three cases") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    CHECK(oracle.answer(ray, Sphere<T>{{5, 0, 0}, 1}) == secant<T>(outside, 4, 6));
    CHECK(oracle.answer(ray, Sphere<T>{{5, 1, 0}, 1}) == tangent<T>(outside, 5));
    CHECK(oracle.answer(ray, Sphere<T>{{5, 2, 0}, 1}) == sphere_miss<T>(outside));
  });
}

TEST_CASE("A tangent may touch where no number is") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{0, 0, 0}, {1, 2, 2}};
    const Sphere<T> sphere{{1, 1, 0}, 1};
    CHECK(oracle.answer(ray, sphere) == tangent<T>(outside, T(1) / T(3)));
    const SphereTruth<T> truth = oracle.truth(ray, sphere);
    CHECK(truth.t[0].rational == mpq_class(1, 3));
    CHECK(truth.t[0].root_sign == 0);
  });
}

TEST_CASE("B = 0: the origin is the point closest to the center") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    CHECK(oracle.answer(ray, Sphere<T>{{0, 0, 0}, 2}) == lone<T>(inside, Root::second, 2));
    CHECK(oracle.answer(ray, Sphere<T>{{0, 2, 0}, 2}) == tangent<T>(on, 0));
    CHECK(oracle.answer(ray, Sphere<T>{{0, 3, 0}, 2}) == sphere_miss<T>(outside));
    const Ray<T> both_ways{{0, 0, 0}, {1, 0, 0}, -10, 10};
    CHECK(oracle.answer(both_ways, Sphere<T>{{0, 0, 0}, 2}) == secant<T>(inside, -2, 2));
  });
}

TEST_CASE("C = 0: the origin is on the sphere") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Sphere<T> sphere{{2, 0, 0}, 2};
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, sphere) == secant<T>(on, 0, 4));
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {-1, 0, 0}}, sphere) == lone<T>(on, Root::second, 0));
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {0, 1, 0}}, sphere) == tangent<T>(on, 0));
  });
}

TEST_CASE("A sphere of radius zero is a point") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{0, 0, 0}, {1, 0, 0}};
    CHECK(oracle.answer(ray, Sphere<T>{{3, 0, 0}, 0}) == tangent<T>(outside, 3));
    CHECK(oracle.answer(ray, Sphere<T>{{3, 0, 0}, T(-0.0)}) == tangent<T>(outside, 3));
    CHECK(oracle.answer(ray, Sphere<T>{{3, 1, 0}, 0}) == sphere_miss<T>(outside));
    CHECK(oracle.answer(ray, Sphere<T>{{0, 0, 0}, 0}) == tangent<T>(on, 0));
    CHECK(oracle.answer(ray, Sphere<T>{{-1, 0, 0}, 0}) == sphere_miss<T>(outside));
  });
}

TEST_CASE("The origin inside sees the second root alone, a sphere behind it none") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Ray<T> ray{{0, 0, 0}, {0, 0, 2}};
    CHECK(oracle.answer(ray, Sphere<T>{{0, 0, 1}, 3}) == lone<T>(inside, Root::second, 2));
    CHECK(oracle.answer(ray, Sphere<T>{{0, 0, -8}, 2}) == sphere_miss<T>(outside));
  });
}

TEST_CASE("Both ends of the range belong to it") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const Sphere<T> sphere{{5, 0, 0}, 1};
    const auto within = [&](T t_min, T t_max) { return oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, t_min, t_max}, sphere); };
    CHECK(within(4, 6) == secant<T>(outside, 4, 6));
    CHECK(within(4, 4) == lone<T>(outside, Root::first, 4));
    CHECK(within(6, 6) == lone<T>(outside, Root::second, 6));
    CHECK(within(5, kInfinity<T>) == lone<T>(outside, Root::second, 6));
    CHECK(within(-1, 5) == lone<T>(outside, Root::first, 4));
    CHECK(within(T(4.5), T(5.5)) == sphere_miss<T>(outside));
    CHECK(within(7, kInfinity<T>) == sphere_miss<T>(outside));
    const Sphere<T> touched{{5, 1, 0}, 1};
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 5, 5}, touched) == tangent<T>(outside, 5));
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, 6, 7}, touched) == sphere_miss<T>(outside));
  });
}

TEST_CASE("Bounds are compared with the exact root, before rounding") {
  // 3 - sqrt(3) lies just below the number nearest to it, in both formats.
  everywhere([]<Real T>(const Oracle& oracle) {
    const Sphere<T> sphere{{3, 1, 0}, 2};
    const T nearest = std::same_as<T, double> ? T(0x1.4498517a7b356p+0) : T(0x1.449852p+0);
    const T second = oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, sphere).t[1];
    const auto within = [&](T t_min, T t_max) { return oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, t_min, t_max}, sphere); };
    CHECK(within(0, nearest) == lone<T>(outside, Root::first, nearest));
    CHECK(within(0, std::nextafter(nearest, T(0))) == sphere_miss<T>(outside));
    CHECK(within(nearest, kInfinity<T>) == lone<T>(outside, Root::second, second));
    CHECK(within(std::nextafter(nearest, T(0)), kInfinity<T>) == secant<T>(outside, nearest, second));
  });
}

TEST_CASE("A near zero: the direction's length changes t and nothing else") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T least = kLeast<T>;
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {least, 0, 0}}, Sphere<T>{{5 * least, 0, 0}, least}) == secant<T>(outside, 4, 6));
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {least, 0, 0}}, Sphere<T>{{5 * least, least, 0}, least}) == tangent<T>(outside, 5));
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {least, 0, 0}}, Sphere<T>{{5, 0, 0}, 1}) ==
          secant<T>(outside, kInfinity<T>, kInfinity<T>));
  });
}

TEST_CASE("Coordinates at both ends of the range of numbers") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T big = kGreatest<T>;
    // From one end of the axis to a sphere of half the greatest radius at the other.
    CHECK(oracle.answer(Ray<T>{{-big, 0, 0}, {big, 0, 0}}, Sphere<T>{{big, 0, 0}, big / 2}) ==
          secant<T>(outside, T(1.5), T(2.5)));
    CHECK(oracle.answer(Ray<T>{{-big, 0, 0}, {big, 0, 0}}, Sphere<T>{{big, big, 0}, big}) == tangent<T>(outside, 2));
    const SphereHit<T> almost = oracle.answer(Ray<T>{{-big, kLeast<T>, 0}, {big, 0, 0}}, Sphere<T>{{big, -big, 0}, big});
    CHECK(almost == sphere_miss<T>(outside));
  });
}

TEST_CASE("Cancellation: the small root of a large sphere") {
  everywhere([]<Real T>(const Oracle& oracle) {
    // Roots 1 and 2 c - 1 of a sphere around c with radius c - 1.
    const T c = 1 / std::numeric_limits<T>::epsilon();
    CHECK(oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{c, 0, 0}, c - 1}) == secant<T>(outside, 1, 2 * c - 1));
    // C = 2^-2p lost beside B^2: with the origin (0, s, 0), s = 2^-p, the sphere of radius 1 around (1, 0, 0) has C = s^2,
    // B = 1 and the small root s^2 / (1 + sqrt(1 - s^2)), the nearest number to which is s^2 / 2.
    const T s = std::numeric_limits<T>::epsilon() / 2;
    CHECK(oracle.answer(Ray<T>{{0, s, 0}, {1, 0, 0}}, Sphere<T>{{1, 0, 0}, 1}) == secant<T>(outside, s * s / 2, 2));
  });
}

TEST_CASE("The truth tells the exact roots") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const SphereTruth<T> truth = oracle.truth(Ray<T>{{0, 0, 0}, {2, 0, 0}}, Sphere<T>{{3, 1, 0}, 2});
    REQUIRE(truth.hit == oracle.answer(Ray<T>{{0, 0, 0}, {2, 0, 0}}, Sphere<T>{{3, 1, 0}, 2}));
    REQUIRE(truth.hit.count() == 2);
    for (int i : {0, 1}) {
      CHECK(truth.t[i].rational == mpq_class(3, 2));
      CHECK(truth.t[i].radicand == mpq_class(3, 4));
      CHECK(truth.t[i].root_sign == (i == 0 ? -1 : 1));
    }
  });
}

}  // namespace
}  // namespace graze::oracle
