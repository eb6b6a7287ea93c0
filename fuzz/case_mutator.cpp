#include "fuzz/case_mutator.hpp"

#include <array>
#include <cmath>

#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/nudge.hpp"
#include "fuzz/kernel_calls.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
Vec3<T> sum(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <Real T>
Vec3<T> scaled(const Vec3<T>& a, T k) {
  return {a.x * k, a.y * k, a.z * k};
}

/// A point that matters: a corner, the middle of an edge or the center of a face, or a point of the sphere on an axis.
template <Real T>
Vec3<T> feature(const Triangle<T>& triangle, Random& random) {
  const std::array corners{triangle.a, triangle.b, triangle.c};
  const Vec3<T> first = corners[random.below(3)], second = corners[random.below(3)];
  if (random.one_in(4)) return scaled(sum(sum(corners[0], corners[1]), corners[2]), T(1) / 3);
  return sum(scaled(first, T(0.5)), scaled(second, T(0.5)));
}
template <Real T>
Vec3<T> feature(const Sphere<T>& sphere, Random& random) {
  std::array<T, 3> offset{};
  if (!random.one_in(4)) offset[random.below(3)] = random.sign() * sphere.radius;
  return sum(sphere.center, {offset[0], offset[1], offset[2]});
}
template <Real T>
Vec3<T> feature(const Case<T>& input, Random& random) {
  if (const auto* query = std::get_if<RaySphere<T>>(&input)) return feature(query->sphere, random);
  return feature(std::get<RayTriangle<T>>(input).triangle, random);
}

template <Real T>
void aim(Case<T>& input, Ray<T>& ray, Random& random) {
  const Vec3<T> target = feature(input, random);
  if (random.one_in(2)) {
    ray.direction = sum(target, scaled(ray.origin, T(-1)));
  } else {
    const int distance = random.between(0, 2);
    ray.origin = sum(target, scaled(ray.direction, T(-distance)));
  }
}

template <Real T>
void put_bound_at_hit(const Case<T>& input, Ray<T>& ray, Random& random) {
  const Answer<T> answer = kernel_answer(input).answer;
  T t{};
  if (const auto* sphere = std::get_if<SphereHit<T>>(&answer)) {
    t = sphere->t[random.below(2)];
  } else {
    const auto& triangle = std::get<TriangleHit<T>>(answer);
    t = random.one_in(2) ? triangle.t : triangle.t_end;
  }
  (random.one_in(2) ? ray.t_min : ray.t_max) = t;
}

template <Real T>
void change_number(const construct::Coordinates<T>& all, Random& random) {
  T& number = *all.at[random.below(all.count)];
  switch (random.below(4)) {
    case 0:
      number = -number;
      break;
    case 1:
      number = static_cast<T>(random.between(-2, 4));
      break;
    default:
      number = *all.at[random.below(all.count)];
      break;
  }
}

/// All numbers, or those of one run of them: the origin, the direction, the shape.
template <Real T>
void scale(const construct::Coordinates<T>& all, bool is_ray, Random& random) {
  std::size_t from = 0, to = all.count;
  if (is_ray && random.one_in(2)) {
    from = 3;
    to = 6;
  }
  const int exponent = random.between(-80, 80);
  for (std::size_t i = from; i < to; ++i) *all.at[i] = std::ldexp(*all.at[i], exponent);
}

/// No NaN and no infinity but as the end of a range: what may be nudged.
template <Real T>
bool is_finite(const construct::Coordinates<T>& all, const Ray<T>* ray) {
  for (std::size_t i = 0; i < all.count; ++i) {
    if (!std::isfinite(*all.at[i])) return false;
  }
  return ray == nullptr || (std::isfinite(ray->t_min) && !std::isnan(ray->t_max));
}

}  // namespace

template <Real T>
void mutate(Case<T>& input, Random& random) {
  const construct::Coordinates<T> all = construct::coordinates(input);
  Ray<T>* ray = construct::ray_of(input);
  const std::uint64_t kind = random.below(ray != nullptr ? 8 : 5);
  if (kind < 2 && is_finite(all, ray)) {
    construct::nudge(input, random);
  } else if (kind < 4) {
    change_number(all, random);
  } else if (kind == 4) {
    scale(all, ray != nullptr, random);
  } else if (kind < 7) {
    aim(input, *ray, random);
  } else {
    put_bound_at_hit(input, *ray, random);
  }
}

template void mutate(Case<float>&, Random&);
template void mutate(Case<double>&, Random&);

}  // namespace graze::fuzz
