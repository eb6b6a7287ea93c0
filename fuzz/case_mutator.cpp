#include "fuzz/case_mutator.hpp"

#include <cmath>
#include <utility>

#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/nudge.hpp"
#include "fuzz/kernel_calls.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <Real T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <Real T>
Vec3<T> operator*(T k, const Vec3<T>& a) {
  return {k * a.x, k * a.y, k * a.z};
}
template <Real T>
T& at(Vec3<T>& v, std::uint64_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
template <Real T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <Real T>
T small(Random& random) {
  return static_cast<T>(random.between(-2, 4));
}

template <Real T>
Vec3<T> offset(T length, Random& random) {
  Vec3<T> v{};
  at(v, random.below(3)) = static_cast<T>(random.sign()) * length;
  return v;
}

/// A corner, the middle of an edge or the center of a face.
template <Real T>
Vec3<T> feature(const RayTriangle<T>& query, Random& random) {
  const std::array corners{query.triangle.a, query.triangle.b, query.triangle.c};
  if (random.one_in(4)) return (T(1) / 3) * (corners[0] + corners[1] + corners[2]);
  const Vec3<T> first = corners[random.below(3)], second = corners[random.below(3)];
  return T(0.5) * first + T(0.5) * second;
}
/// The center, or a point of the sphere on an axis.
template <Real T>
Vec3<T> feature(const RaySphere<T>& query, Random& random) {
  if (random.one_in(4)) return query.sphere.center;
  return query.sphere.center + offset(query.sphere.radius, random);
}

/// In the plane across an axis through a point of the sphere on that axis; or with the radius that touches, rounded.
template <Real T>
void touch(RaySphere<T>& query, Random& random) {
  auto& [ray, sphere] = query;
  if (random.one_in(2)) {
    const Vec3<T> l = sphere.center - ray.origin;
    const T along = dot(ray.direction, l);
    sphere.radius = std::sqrt(std::abs(dot(l, l) - along * along / dot(ray.direction, ray.direction)));
    return;
  }
  const std::uint64_t axis = random.below(3);
  at(ray.direction, axis) = 0;
  const T way = small<T>(random);
  const T aside = static_cast<T>(random.sign()) * sphere.radius;
  sphere.center = ray.origin + way * ray.direction;
  at(sphere.center, axis) = at(ray.origin, axis) + aside;
}
/// Through a lattice point of the triangle's plane, along a lattice vector of it: so often along an edge or to a corner.
template <Real T>
void touch(RayTriangle<T>& query, Random& random) {
  auto& [ray, triangle] = query;
  const Vec3<T> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const auto i = static_cast<T>(random.between(0, 2)), j = static_cast<T>(random.between(0, 1));
  const T k = small<T>(random), l = small<T>(random);
  const auto ways = static_cast<T>(random.between(-1, 2));
  ray.direction = k * ab + l * ac;
  ray.origin = triangle.a + i * ab + j * ac - ways * ray.direction;
}
template <Real T>
void touch(PointLine<T>& query, Random&) {
  query.line.c = -(query.line.a * query.point.x + query.line.b * query.point.y);
}
template <Real T>
void touch(PointPlane<T>& query, Random&) {
  query.plane.d = -dot(Vec3<T>{query.plane.a, query.plane.b, query.plane.c}, query.point);
}
template <Real T>
void touch(PointSphere<T>& query, Random& random) {
  if (random.one_in(2)) {
    query.point = query.sphere.center + offset(query.sphere.radius, random);
  } else {
    const Vec3<T> l = query.point - query.sphere.center;
    query.sphere.radius = std::sqrt(dot(l, l));
  }
}

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

/// Every vector of the case: points, directions, coefficients.
template <Real T, class F>
void each_vector(Case<T>& input, F f) {
  std::visit(
      [&](auto& query) {
        const auto coefficients = [&](auto& of) {
          Vec3<T> v{of.a, of.b, of.c};
          f(v);
          of.a = v.x, of.b = v.y, of.c = v.z;
        };
        if constexpr (requires { query.ray; }) {
          f(query.ray.origin);
          f(query.ray.direction);
        } else if constexpr (requires { query.point.z; }) {
          f(query.point);
        }
        if constexpr (requires { query.triangle; }) {
          f(query.triangle.a);
          f(query.triangle.b);
          f(query.triangle.c);
        }
        if constexpr (requires { query.sphere; }) f(query.sphere.center);
        if constexpr (requires { query.plane; }) coefficients(query.plane);
      },
      input);
}

template <Real T>
void permute(Case<T>& input, Random& random) {
  auto* triangle_case = std::get_if<RayTriangle<T>>(&input);
  Ray<T>* ray = construct::ray_of(input);
  const std::uint64_t first = random.below(3), second = (first + 1 + random.below(2)) % 3;
  switch (random.below(ray == nullptr ? 2 : triangle_case == nullptr ? 3 : 5)) {
    case 0:
      if (auto* line_case = std::get_if<PointLine<T>>(&input)) {
        std::swap(line_case->point.x, line_case->point.y);
        std::swap(line_case->line.a, line_case->line.b);
      }
      each_vector(input, [&](Vec3<T>& v) { std::swap(at(v, first), at(v, second)); });
      break;
    case 1:
      if (auto* line_case = std::get_if<PointLine<T>>(&input)) {
        line_case->point.x = -line_case->point.x;
        line_case->line.a = -line_case->line.a;
      }
      each_vector(input, [&](Vec3<T>& v) { at(v, first) = -at(v, first); });
      break;
    case 2:
      ray->direction = T(-1) * ray->direction;
      break;
    default: {
      const std::array corners{&triangle_case->triangle.a, &triangle_case->triangle.b, &triangle_case->triangle.c};
      std::swap(*corners[first], *corners[second]);
      break;
    }
  }
}

template <Real T>
bool collapse(Case<T>& input, Random& random) {
  if (auto* query = std::get_if<RayTriangle<T>>(&input)) {
    auto& [a, b, c] = query->triangle;
    const T k = small<T>(random);
    c = a + k * (b - a);
    return true;
  }
  const construct::Coordinates<T> all = construct::coordinates(input);
  if (all.radius >= all.count) return false;
  *all.at[all.radius] = 0;
  return true;
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

/// No NaN and no infinity but as the end of a range: what may be nudged.
template <Real T>
bool is_finite(const construct::Coordinates<T>& all, const Ray<T>* ray) {
  for (std::size_t i = 0; i < all.count; ++i) {
    if (!std::isfinite(*all.at[i])) return false;
  }
  return ray == nullptr || (std::isfinite(ray->t_min) && !std::isnan(ray->t_max));
}

/// Calls f with the query that has a ray; false for the others.
template <Real T, class F>
bool with_ray(Case<T>& input, F f) {
  return std::visit(
      [&](auto& query) {
        if constexpr (requires { query.ray; }) {
          f(query);
          return true;
        } else {
          return false;
        }
      },
      input);
}

}  // namespace

template <Real T>
bool mutate(Case<T>& input, Mutation mutation, Random& random) {
  const construct::Coordinates<T> all = construct::coordinates(input);
  T& number = *all.at[random.below(all.count)];
  switch (mutation) {
    case Mutation::nudge:
      if (!is_finite(all, construct::ray_of(input))) return false;
      construct::nudge(input, random);
      return true;
    case Mutation::copy:
      number = *all.at[random.below(all.count)];
      return true;
    case Mutation::negate:
      number = -number;
      return true;
    case Mutation::simplify:
      number = small<T>(random);
      return true;
    case Mutation::scale:
      scale(all, construct::ray_of(input) != nullptr, random);
      return true;
    case Mutation::permute:
      permute(input, random);
      return true;
    case Mutation::aim:
      return with_ray(input, [&](auto& query) { query.ray.direction = feature(query, random) - query.ray.origin; });
    case Mutation::start:
      return with_ray(input, [&](auto& query) {
        const Vec3<T> target = feature(query, random);
        const auto ways = static_cast<T>(random.between(0, 2));
        query.ray.origin = target - ways * query.ray.direction;
      });
    case Mutation::touch:
      std::visit([&](auto& query) { touch(query, random); }, input);
      return true;
    case Mutation::collapse:
      return collapse(input, random);
    case Mutation::bound:
      return with_ray(input, [&](auto& query) { put_bound_at_hit(input, query.ray, random); });
  }
  return false;
}

template <Real T>
void mutate(Case<T>& input, Random& random) {
  // Some change always applies, so this ends.
  while (!mutate(input, mutations[random.below(mutations.size())], random)) {
  }
}

template bool mutate(Case<float>&, Mutation, Random&);
template bool mutate(Case<double>&, Mutation, Random&);
template void mutate(Case<float>&, Random&);
template void mutate(Case<double>&, Random&);

}  // namespace graze::fuzz
