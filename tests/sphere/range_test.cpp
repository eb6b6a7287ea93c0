// Ray and sphere by hand: which roots lie in the ray's range.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using enum OriginSide;

template <Real T>
void check_within(const Sphere<T>& sphere, T t_min, T t_max, const SphereHit<T>& expected) {
  CAPTURE(t_min, t_max);
  check_answer(Ray<T>{{0, 0, 0}, {1, 0, 0}, t_min, t_max}, sphere, expected);
}

TEST_CASE("Both ends of the range belong to it, the next number beyond does not") {
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{5, 0, 0}, 1};
    const auto below = [](T x) { return std::nextafter(x, T(0)); };
    const auto above = [](T x) { return std::nextafter(x, T(99)); };
    const T infinity = kInfinity<T>;
    check_within<T>(sphere, 4, 6, secant<T>(outside, 4, 6));
    check_within<T>(sphere, below(4), above(6), secant<T>(outside, 4, 6));
    check_within<T>(sphere, above(4), 6, lone<T>(outside, Root::second, 6));
    check_within<T>(sphere, 4, below(6), lone<T>(outside, Root::first, 4));
    check_within<T>(sphere, above(4), below(6), sphere_miss<T>(outside));
    check_within<T>(sphere, 4, 4, lone<T>(outside, Root::first, 4));
    check_within<T>(sphere, 6, 6, lone<T>(outside, Root::second, 6));
    check_within<T>(sphere, 6, infinity, lone<T>(outside, Root::second, 6));
    check_within<T>(sphere, above(6), infinity, sphere_miss<T>(outside));
    check_within<T>(sphere, -9, 4, lone<T>(outside, Root::first, 4));
    check_within<T>(sphere, -9, below(4), sphere_miss<T>(outside));
    check_within<T>(sphere, 5, 5, sphere_miss<T>(outside));
    check_within<T>(sphere, kGreatest<T>, infinity, sphere_miss<T>(outside));
    check_within<T>(sphere, -kGreatest<T>, kGreatest<T>, secant<T>(outside, 4, 6));
  });
}

TEST_CASE("A tangent lies in the range or not") {
  in_both_formats([]<Real T>() {
    const Sphere<T> touched{{5, 1, 0}, 1}, behind{{-5, 1, 0}, 1};
    check_within<T>(touched, 5, 5, tangent<T>(outside, 5));
    check_within<T>(touched, std::nextafter(T(5), T(9)), 9, sphere_miss<T>(outside));
    check_within<T>(touched, 0, std::nextafter(T(5), T(0)), sphere_miss<T>(outside));
    check_within<T>(behind, -5, 0, tangent<T>(outside, -5));
    check_within<T>(behind, 0, kInfinity<T>, sphere_miss<T>(outside));
  });
}

TEST_CASE("A negative start reaches behind the origin") {
  in_both_formats([]<Real T>() {
    const Sphere<T> behind{{-5, 0, 0}, 1}, around{{1, 0, 0}, 3};
    check_within<T>(behind, -6, kInfinity<T>, secant<T>(outside, -6, -4));
    check_within<T>(behind, -5, 0, lone<T>(outside, Root::second, -4));
    check_within<T>(behind, -9, -5, lone<T>(outside, Root::first, -6));
    check_within<T>(behind, -kLeast<T>, kInfinity<T>, sphere_miss<T>(outside));
    check_within<T>(around, -2, 4, secant<T>(inside, -2, 4));
    check_within<T>(around, -1, 4, lone<T>(inside, Root::second, 4));
    check_within<T>(around, -2, 0, lone<T>(inside, Root::first, -2));
    check_within<T>(around, -1, 3, sphere_miss<T>(inside));
  });
}

TEST_CASE("Ends are compared with the exact root, before rounding") {
  // 3 - sqrt(3) lies just below the number nearest to it, in both formats.
  in_both_formats([]<Real T>() {
    const Sphere<T> sphere{{3, 1, 0}, 2};
    const T nearest = std::same_as<T, double> ? T(0x1.4498517a7b356p+0) : T(0x1.449852p+0);
    const T second = intersect(Ray<T>{{0, 0, 0}, {1, 0, 0}}, sphere).t[1], before = std::nextafter(nearest, T(0));
    check_within<T>(sphere, 0, nearest, lone<T>(outside, Root::first, nearest));
    check_within<T>(sphere, 0, before, sphere_miss<T>(outside));
    check_within<T>(sphere, nearest, kInfinity<T>, lone<T>(outside, Root::second, second));
    check_within<T>(sphere, before, kInfinity<T>, secant<T>(outside, nearest, second));
    check_within<T>(sphere, nearest, nearest, sphere_miss<T>(outside));
    check_within<T>(sphere, before, nearest, lone<T>(outside, Root::first, nearest));
  });
}

TEST_CASE("A printed tangent may exclude itself") {
  in_both_formats([]<Real T>() {
    // t = 1/3, which float rounds up and double down.
    const T third = T(1) / T(3);
    const Sphere<T> sphere{{1, 1, 0}, 1};
    const bool is_above = std::same_as<T, float>;
    const SphereHit<T> touch = tangent<T>(outside, third), miss = sphere_miss<T>(outside);
    check_answer(Ray<T>{{0, 0, 0}, {1, 2, 2}, third}, sphere, is_above ? miss : touch);
    check_answer(Ray<T>{{0, 0, 0}, {1, 2, 2}, 0, third}, sphere, is_above ? touch : miss);
    check_answer(Ray<T>{{0, 0, 0}, {1, 2, 2}, third, third}, sphere, miss);
  });
}

TEST_CASE("A root between zero and the least number is neither") {
  in_both_formats([]<Real T>() {
    // Roots a quarter of the least number and one least number and a quarter, up to the direction's length.
    const T least = kLeast<T>;
    const Sphere<T> sphere{{3 * least, 0, 0}, 2 * least};
    const auto ray = [&](T t_min, T t_max) { return Ray<T>{{0, 0, 0}, {4, 0, 0}, t_min, t_max}; };
    check_answer(ray(0, kInfinity<T>), sphere, secant<T>(outside, 0, least));
    check_answer(ray(least, kInfinity<T>), sphere, lone<T>(outside, Root::second, least));
    check_answer(ray(0, 0), sphere, sphere_miss<T>(outside));
    check_answer(ray(-least, 0), sphere, sphere_miss<T>(outside));
    check_answer(ray(-least, least), sphere, lone<T>(outside, Root::first, 0));
  });
}

}  // namespace
}  // namespace graze::test
