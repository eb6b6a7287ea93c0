// Random input from which boundaries are aimed at.
#pragma once

#include "tests/support/bit_patterns.hpp"

namespace graze::test {

template <Real T>
[[nodiscard]] Vec3<T> random_point(fuzz::Random& random) {
  Vec3<T> v{};
  const int size = random.between(-3, 3);
  for (T* x : {&v.x, &v.y, &v.z}) *x = random_of_size<T>(random, size);
  return v;
}

/// A range with an end at t or a few ulps off it.
template <Real T>
void aim_range(Ray<T>& ray, T t, fuzz::Random& random) {
  for (int ulps = random.between(-4, 4); ulps != 0; ulps += ulps < 0 ? 1 : -1) t = std::nextafter(t, ulps < 0 ? T(-9) : T(9));
  if (random.one_in(2)) {
    ray.t_min = t;
    if (random.one_in(2)) ray.t_max = std::fmax(t, T(1));
  } else {
    ray.t_min = random.one_in(2) ? T(0) : std::fmin(t, T(0)) - T(random.below(3));
    ray.t_max = std::fmax(t, ray.t_min);
  }
}

}  // namespace graze::test
