// Seeded random input of several sorts, made so that what is rare under uniform numbers becomes common.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "graze/types.hpp"

namespace graze::oracle {

enum class Sort {
  lattice,          ///< integers from -2 to 2: degenerate, coplanar and tangent cases all the time
  scaled_lattice,   ///< the same times one power of two, down to the least subnormal and up to the largest number
  uniform,          ///< random numbers in (-1, 1)
  bit_patterns,     ///< random bits, now and then not finite
  mixed_exponents,  ///< small integers times a power of two each
  contacts,         ///< tangents, edges and corners by construction, then perhaps nudged by an ulp
};

/// A stream of cases that depends on the seed alone, so each draw is a statement or an initializer of its own: the order of
/// arguments is the compiler's.
template <Real T>
class RandomCases {
 public:
  RandomCases(Sort sort, std::uint64_t seed) : sort_(sort), engine_(seed) {}

  [[nodiscard]] Ray<T> ray() {
    if (sort_ == Sort::scaled_lattice) scale_ = exponent(0);
    Ray<T> ray{vec3(), vec3()};
    if (one_in(64)) ray.direction = {};
    return ray;
  }

  [[nodiscard]] Sphere<T> sphere() {
    const T radius = coordinate();
    return {vec3(), one_in(64) ? radius : std::abs(radius)};
  }

  [[nodiscard]] Triangle<T> triangle() { return {vec3(), vec3(), vec3()}; }

  /// A sphere that the ray touches at an integer t, or nearly; sets the ray.
  [[nodiscard]] Sphere<T> touched_sphere(Ray<T>& ray) {
    // (1, 2, 2), (2, 1, -2) and (2, -2, 1) are orthogonal and all of length 3.
    const int stretch = integer(1, 9), t = integer(-3, 9), offset = integer(-9, 9);
    const Vec3<T> e = integers(20);
    ray = {e, {T(stretch), T(2 * stretch), T(2 * stretch)}};
    const int along = stretch * t;
    Sphere<T> sphere{{e.x + T(along + 2 * offset), e.y + T(2 * along + offset), e.z + T(2 * along - 2 * offset)},
                     T(3 * std::abs(offset))};
    for (T* x : {&ray.direction.x, &ray.origin.y, &sphere.center.z, &sphere.radius}) maybe_nudge(*x);
    return sphere;
  }

  /// A triangle that the ray meets on an edge, at a corner or beside it; sets the ray.
  [[nodiscard]] Triangle<T> grazed_triangle(Ray<T>& ray) {
    const Vec3<T> a = integers(9), p = integers(9), q = integers(9), d = integers(5);
    const int i = integer(-1, 4), j = one_in(3) ? 4 - i : integer(-1, 4), t = integer(-2, 6);
    const auto aim = [&](T a_i, T p_i, T q_i, T d_i) { return a_i + T(i) * p_i + T(j) * q_i - T(t) * d_i; };
    // The hit is a + (i E1 + j E2) / 4 with E1 = 4 p, E2 = 4 q, so all numbers are integers.
    ray = {{aim(a.x, p.x, q.x, d.x), aim(a.y, p.y, q.y, d.y), aim(a.z, p.z, q.z, d.z)}, d};
    Triangle<T> triangle{a, {a.x + 4 * p.x, a.y + 4 * p.y, a.z + 4 * p.z}, {a.x + 4 * q.x, a.y + 4 * q.y, a.z + 4 * q.z}};
    for (T* x : {&ray.direction.x, &ray.origin.y, &triangle.a.z, &triangle.b.x, &triangle.c.y}) maybe_nudge(*x);
    return triangle;
  }

  /// A range around numbers of which some are known to matter, such as a rounded answer.
  void set_range(Ray<T>& ray, T first, T second) {
    ray.t_min = bound(first);
    if (one_in(2)) ray.t_max = bound(one_in(2) ? first : second);
    if (ray.t_min > ray.t_max && !one_in(16)) std::swap(ray.t_min, ray.t_max);
  }

  [[nodiscard]] T coordinate() {
    switch (sort_) {
      case Sort::scaled_lattice:
        return std::ldexp(T(integer(-2, 2)), scale_);
      case Sort::uniform: {
        if (one_in(16)) return 0;
        return std::ldexp(T(static_cast<std::int64_t>(engine_()) >> 11), -52);
      }
      case Sort::bit_patterns:
        if constexpr (std::same_as<T, double>) {
          return std::bit_cast<double>(engine_());
        } else {
          return std::bit_cast<float>(static_cast<std::uint32_t>(engine_()));
        }
      case Sort::mixed_exponents: {
        const int power = one_in(4) ? exponent(2) : integer(-40, 40);
        return std::ldexp(T(integer(-3, 3)), power);
      }
      default:
        return T(integer(-2, 2));
    }
  }

  [[nodiscard]] Vec3<T> vec3() { return {coordinate(), coordinate(), coordinate()}; }

  [[nodiscard]] bool one_in(std::uint64_t n) { return engine_() % n == 0; }

 private:
  [[nodiscard]] int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  [[nodiscard]] Vec3<T> integers(int size) {
    return {T(integer(-size, size)), T(integer(-size, size)), T(integer(-size, size))};
  }

  /// Any exponent with which a number of that many bits above 1 is still finite.
  [[nodiscard]] int exponent(int spare) {
    using Limits = std::numeric_limits<T>;
    return integer(Limits::min_exponent - Limits::digits, Limits::max_exponent - 3 - spare);
  }

  void maybe_nudge(T& x) {
    if (one_in(6)) x = std::nextafter(x, one_in(2) ? T(-1000) : T(1000));
  }

  [[nodiscard]] T bound(T x) {
    if (!std::isfinite(x)) return T(0);
    if (one_in(8)) return coordinate();
    maybe_nudge(x);
    return x;
  }

  Sort sort_;
  int scale_ = 0;
  std::mt19937_64 engine_;
};

}  // namespace graze::oracle
