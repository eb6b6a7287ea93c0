// Ray and triangle by hand: whether the common point lies in the ray's range.
#include <cmath>

#include "tests/support/ask.hpp"
#include "tests/support/formats.hpp"
#include "tests/triangle/corners.hpp"

namespace graze::test {
namespace {

using enum TriangleKind;
using enum Facing;

/// Down from height 5, through the face, an edge and a corner.
template <Real T>
void check_within(T t_min, T t_max, bool is_hit) {
  CAPTURE(t_min, t_max);
  const auto ask = [&](T x, T y, TriangleKind kind, T u, T v) {
    check_answer(Ray<T>{{x, y, 5}, {0, 0, -1}, t_min, t_max}, right<T>,
                 is_hit ? at_point<T>(kind, front, 5, u, v) : triangle_miss<T>(front));
  };
  ask(1, 1, face, T(0.25), T(0.25));
  ask(2, 2, edge_bc, T(0.5), T(0.5));
  ask(0, 4, vertex_c, 0, 1);
}

TEST_CASE("Both ends of the range belong to it, the next number beyond does not") {
  in_both_formats([]<Real T>() {
    const T below = std::nextafter(T(5), T(0)), above = std::nextafter(T(5), T(9));
    check_within<T>(5, 5, true);
    check_within<T>(0, 5, true);
    check_within<T>(5, kInfinity<T>, true);
    check_within<T>(below, above, true);
    check_within<T>(-kGreatest<T>, kGreatest<T>, true);
    check_within<T>(0, below, false);
    check_within<T>(above, kInfinity<T>, false);
    check_within<T>(above, above, false);
    check_within<T>(-9, 0, false);
    check_within<T>(kGreatest<T>, kInfinity<T>, false);
  });
}

TEST_CASE("A point behind the origin is met where the range reaches back") {
  in_both_formats([]<Real T>() {
    const auto up = [](T t_min) { return Ray<T>{{1, 1, 3}, {0, 0, 2}, t_min}; };
    check_answer(up(0), right<T>, triangle_miss<T>(back));
    check_answer(up(T(-1.5)), right<T>, at_point<T>(face, back, T(-1.5), T(0.25), T(0.25)));
    check_answer(up(std::nextafter(T(-1.5), T(0))), right<T>, triangle_miss<T>(back));
  });
}

TEST_CASE("Ends are compared with the exact t, before rounding") {
  in_both_formats([]<Real T>() {
    // t = 1/3, which float rounds up and double down.
    const T third = T(1) / T(3);
    const bool is_above = std::same_as<T, float>;
    const auto hit = at_point<T>(face, front, third, T(0.25), T(0.25)), miss = triangle_miss<T>(front);
    const auto ray = [](T t_min, T t_max) { return Ray<T>{{1, 1, 1}, {0, 0, -3}, t_min, t_max}; };
    check_answer(ray(third, 1), right<T>, is_above ? miss : hit);
    check_answer(ray(0, third), right<T>, is_above ? hit : miss);
    check_answer(ray(third, third), right<T>, miss);
    check_answer(ray(std::nextafter(third, T(0)), std::nextafter(third, T(1))), right<T>, hit);
  });
}

TEST_CASE("t below zero by less than any number is a miss; above it, a hit at zero") {
  in_both_formats([]<Real T>() {
    const T least = kLeast<T>;
    const auto from = [](T z) { return Ray<T>{{1, 1, z}, {0, 0, -4}}; };
    check_answer(from(-least), right<T>, triangle_miss<T>(front));
    check_answer(from(least), right<T>, at_point<T>(face, front, 0, T(0.25), T(0.25)));
    check_answer(from(0), right<T>, at_point<T>(face, front, 0, T(0.25), T(0.25)));
    // A quarter of the least number lies beyond a range that ends at zero, half of it ties to zero, three quarters round up.
    check_answer(Ray<T>{{1, 1, least}, {0, 0, -4}, 0, 0}, right<T>, triangle_miss<T>(front));
    check_answer(from(2 * least), right<T>, at_point<T>(face, front, 0, T(0.25), T(0.25)));
    check_answer(from(3 * least), right<T>, at_point<T>(face, front, least, T(0.25), T(0.25)));
    check_answer(Ray<T>{{1, 1, -least}, {0, 0, -4}, -least}, right<T>, at_point<T>(face, front, 0, T(0.25), T(0.25)));
  });
}

}  // namespace
}  // namespace graze::test
