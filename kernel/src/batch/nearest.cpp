// The nearest of many shapes along one ray. Numbers as they are rounded order all but equals, and those exact integers do.
#include <algorithm>

#include "batch/columns.hpp"
#include "batch/sheared_ray.hpp"
#include "exact/order.hpp"
#include "exact/validate.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::batch {
namespace {

template <Real T>
[[nodiscard]] T first_value(const TriangleHit<T>& hit) noexcept {
  return hit.t;
}
template <Real T>
[[nodiscard]] T first_value(const SphereHit<T>& hit) noexcept {
  return hit.t[0];
}

template <Real T>
[[nodiscard]] bool is_hit(const TriangleHit<T>& hit) noexcept {
  return hit.kind != TriangleKind::miss && hit.kind != TriangleKind::invalid;
}
template <Real T>
[[nodiscard]] bool is_hit(const SphereHit<T>& hit) noexcept {
  return hit.kind != SphereKind::miss && hit.kind != SphereKind::invalid;
}

/// An upper end of the range that loses no hit whose exact t is at most one that rounds to t: the next number above, or a
/// greater one whose size the lanes take.
template <Real T>
[[nodiscard]] T at_least(T t) noexcept {
  using namespace numeric;
  if (magnitude_bits(t) < bits_of(Bounds<T>::low)) return Bounds<T>::low;
  const Bits<T> bits = bits_of(t);
  return std::bit_cast<T>((bits & sign_bit<T>) != 0 ? bits - 1 : bits + 1);
}

/// The ray of what may still be nearer; a hit that ends beyond the ray's own end leaves it as it is.
template <Real T>
[[nodiscard]] Ray<T> shortened(const Ray<T>& ray, T t) noexcept {
  Ray<T> out = ray;
  if (!numeric::is_finite(t)) return out;
  const T end = at_least(t);
  if (numeric::order_key(end) < numeric::order_key(ray.t_max)) out.t_max = end;
  return out;
}

template <Real T>
void settle_one_ray(const Ray<T>& ray, const TriangleArrays<T>& triangles, std::size_t first, std::size_t count,
                    Verdicts& out) noexcept {
  if (const auto sheared = shear(ray)) return settle(*sheared, columns_along(*sheared, triangles), first, count, out);
  settle(Run{columns(ray), columns(triangles), false, true, has_range(ray)}, first, count, out);
}
template <Real T>
void settle_one_ray(const Ray<T>& ray, const SphereArrays<T>& spheres, std::size_t first, std::size_t count,
                    Verdicts& out) noexcept {
  settle(Run{columns(ray), columns(spheres), false, true, has_range(ray)}, first, count, out);
}

/// Runs of a few words, each by a ray that ends at the nearest hit so far: after the first hits few lanes are left.
template <class Hit, Real T, class Shapes>
[[nodiscard]] Nearest<Hit> nearest_of(const Ray<T>& ray, const Shapes& shapes) noexcept {
  constexpr std::size_t lanes_at_a_time = 256;
  Nearest<Hit> best{shapes.size, {}};
  best.hit.status = exact::status_of(ray, true, false);
  if (best.hit.status != Status::ok) {
    best.hit.kind = decltype(best.hit.kind)::invalid;
    return best;
  }
  Ray<T> left = ray;
  Verdicts verdicts;
  const auto consider = [&](std::size_t i) {
    const auto shape = lane(shapes, i);
    const Hit hit = graze::intersect(ray, shape);
    if (!is_hit(hit)) return;
    if (best.index < shapes.size) {
      const auto t = numeric::order_key(first_value(hit)), least = numeric::order_key(first_value(best.hit));
      if (t > least || (t == least && exact::compare_first(ray, shape, lane(shapes, best.index)) >= 0)) return;
    }
    best = {i, hit};
  };
  for (std::size_t first = 0; first < shapes.size; first += lanes_at_a_time) {
    const std::size_t count = std::min(lanes_at_a_time, shapes.size - first), before = best.index;
    settle_one_ray(left, shapes, first, count, verdicts);
    for (std::size_t word = 0; 64 * word < count; ++word) {
      for_each_bit((verdicts.hit[word] | verdicts.doubt[word]) & present(count - 64 * word),
                   [&](std::size_t bit) { consider(first + 64 * word + bit); });
    }
    if (best.index != before) left = shortened(ray, first_value(best.hit));
  }
  return best;
}

}  // namespace

template <Real T>
Nearest<TriangleHit<T>> nearest(const Ray<T>& ray, const TriangleArrays<T>& triangles) noexcept {
  return nearest_of<TriangleHit<T>>(ray, triangles);
}
template <Real T>
Nearest<SphereHit<T>> nearest(const Ray<T>& ray, const SphereArrays<T>& spheres) noexcept {
  return nearest_of<SphereHit<T>>(ray, spheres);
}

template Nearest<TriangleHit<float>> nearest(const Ray<float>&, const TriangleArrays<float>&) noexcept;
template Nearest<TriangleHit<double>> nearest(const Ray<double>&, const TriangleArrays<double>&) noexcept;
template Nearest<SphereHit<float>> nearest(const Ray<float>&, const SphereArrays<float>&) noexcept;
template Nearest<SphereHit<double>> nearest(const Ray<double>&, const SphereArrays<double>&) noexcept;

}  // namespace graze::batch
