// Ray and sphere at both ends of the range of numbers, and at every scale between.
#include <cmath>

#include "fuzz/random.hpp"
#include "tests/support/agreement.hpp"
#include "tests/support/ask.hpp"
#include "tests/support/scaled.hpp"

namespace graze::test {
namespace {

using enum OriginSide;

TEST_CASE("The least numbers make spheres like others") {
  in_both_formats([]<Real T>() {
    const T least = kLeast<T>;
    const Ray<T> ray{{0, 0, 0}, {least, 0, 0}};
    check_answer(ray, Sphere<T>{{5 * least, 0, 0}, least}, secant<T>(outside, 4, 6));
    check_answer(ray, Sphere<T>{{5 * least, least, 0}, least}, tangent<T>(outside, 5));
    check_answer(ray, Sphere<T>{{5 * least, 2 * least, 0}, least}, sphere_miss<T>(outside));
    check_answer(ray, Sphere<T>{{5, 0, 0}, 1}, secant<T>(outside, kInfinity<T>, kInfinity<T>));
    check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{5 * least, 0, 0}, 4 * least}, secant<T>(outside, least, 9 * least));
  });
}

TEST_CASE("The largest numbers make spheres like others") {
  in_both_formats([]<Real T>() {
    const T big = kGreatest<T>;
    const Ray<T> across{{-big, 0, 0}, {big, 0, 0}};
    check_answer(across, Sphere<T>{{big, 0, 0}, big / 2}, secant<T>(outside, T(1.5), T(2.5)));
    check_answer(across, Sphere<T>{{big, big, 0}, big}, tangent<T>(outside, 2));
    check_answer(across, Sphere<T>{{big, big, 0}, std::nextafter(big, T(0))}, sphere_miss<T>(outside));
    check_answer(Ray<T>{{-big, kLeast<T>, 0}, {big, 0, 0}}, Sphere<T>{{big, -big, 0}, big}, sphere_miss<T>(outside));
    check_answer(Ray<T>{{-big, -kLeast<T>, 0}, {0, 0, 1}}, Sphere<T>{{big, 0, 0}, big}, sphere_miss<T>(outside));
    // Twice the largest number is no number; the exact t is compared, the printed one is infinite.
    check_answer(Ray<T>{{-big, 0, 0}, {1, 0, 0}}, Sphere<T>{{big, 0, 0}, 0}, tangent<T>(outside, kInfinity<T>));
    check_answer(Ray<T>{{-big, 0, 0}, {1, 0, 0}, 0, big}, Sphere<T>{{big, 0, 0}, 0}, sphere_miss<T>(outside));
    check_answer(Ray<T>{{-big, 0, 0}, {1, 0, 0}, 0, big}, Sphere<T>{{big, 0, 0}, big}, lone<T>(outside, Root::first, big));
  });
}

TEST_CASE("Overflow is to nearest: half a unit beyond the largest number is the first infinity") {
  in_both_formats([]<Real T>() {
    const T big = kGreatest<T>,
            half_unit = std::ldexp(T(1), std::numeric_limits<T>::max_exponent - std::numeric_limits<T>::digits - 1);
    const auto at = [&](T offset) { return intersect(Ray<T>{{-offset, 0, 0}, {1, 0, 0}}, Sphere<T>{{big, 0, 0}, 0}).t[0]; };
    CHECK(at(0) == big);
    CHECK(at(std::nextafter(half_unit, T(0))) == big);
    CHECK(at(half_unit) == kInfinity<T>);
  });
}

TEST_CASE("A range of the largest and the least numbers is kept apart from rounding") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{kLeast<T>, 0, 0}, 0};
    const auto ray = [](T length, T t_min, T t_max) { return Ray<T>{{0, 0, 0}, {length, 0, 0}, t_min, t_max}; };
    check_answer(ray(2, 0, kLeast<T>), sphere, tangent<T>(outside, 0));
    check_answer(ray(2, kLeast<T>, 1), sphere, sphere_miss<T>(outside));
    check_answer(ray(2, 0, 0), sphere, sphere_miss<T>(outside));
    check_answer(ray(T(1.25), 0, 1), sphere, tangent<T>(outside, kLeast<T>));
    check_answer(ray(T(1.25), kLeast<T>, 1), sphere, sphere_miss<T>(outside));
  });
}

/// Small integers, of which many touch, start on the sphere or have exact roots.
template <Real T>
fuzz::RaySphere<T> random_lattice_query(fuzz::Random& random) {
  const auto point = [&] {
    const int x = random.between(-4, 4), y = random.between(-4, 4), z = random.between(-4, 4);
    return Vec3<T>{T(x), T(y), T(z)};
  };
  fuzz::RaySphere<T> query{{point(), point()}, {point(), T(random.between(0, 6))}};
  if (query.ray.direction == Vec3<T>{}) query.ray.direction.z = 1;
  query.ray.t_min = T(random.between(-3, 1));
  return query;
}

TEST_CASE("A power of two on all lengths changes no bit") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 12;
    CAPTURE(seed);
    fuzz::Random random(seed, "scaled spheres", sizeof(T));
    for (int exponent = lowest_exponent<T>; exponent <= highest_exponent<T>; ++exponent) {
      for (int i = 0; i < 8; ++i) {
        const fuzz::RaySphere<T> base = random_lattice_query<T>(random), query = scaled(base, exponent, exponent);
        const SphereHit<T> expected = intersect(base.ray, base.sphere), found = intersect(query.ray, query.sphere);
        if (fuzz::same_bits(found, expected)) continue;
        CAPTURE(exponent, found, expected);
        INFO(fuzz::format_case(fuzz::Case<T>(query)));
        REQUIRE(fuzz::same_bits(found, expected));
      }
    }
  });
}

TEST_CASE("Powers of two on positions and directions apart, against the oracle") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 13;
    CAPTURE(seed);
    fuzz::Random random(seed, "stretched spheres", sizeof(T));
    for (int i = 0; i < 6000; ++i) {
      const int positions = random.between(lowest_exponent<T>, highest_exponent<T>);
      const int directions = random.between(lowest_exponent<T>, highest_exponent<T>);
      require_agreement_in_all_environments(fuzz::Case<T>(scaled(random_lattice_query<T>(random), positions, directions)));
    }
  });
}

}  // namespace
}  // namespace graze::test
