// Batches of the families' cases.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fuzz/batch_check.hpp"
#include "fuzz/family.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
std::optional<std::pair<Ray<T>, Sphere<T>>> parts(const Case<T>& input, const Sphere<T>*) {
  const auto* query = std::get_if<RaySphere<T>>(&input);
  return query ? std::optional(std::pair{query->ray, query->sphere}) : std::nullopt;
}
template <Real T>
std::optional<std::pair<Ray<T>, Triangle<T>>> parts(const Case<T>& input, const Triangle<T>*) {
  const auto* query = std::get_if<RayTriangle<T>>(&input);
  return query ? std::optional(std::pair{query->ray, query->triangle}) : std::nullopt;
}

/// A case of that family at a random index, if it is one of the query.
template <Real T, template <class> class Shape>
std::optional<std::pair<Ray<T>, Shape<T>>> draw_of(Random& random, const Family& family) {
  const std::uint64_t seed = random.bits(), index = random.below(1000);
  return parts(make<T>(family, seed, index).input, static_cast<const Shape<T>*>(nullptr));
}
/// The same, or a case of the next families where it has none of the query.
template <Real T, template <class> class Shape>
std::pair<Ray<T>, Shape<T>> draw(Random& random, std::size_t family) {
  for (;; ++family) {
    if (auto found = draw_of<T, Shape>(random, families()[family % families().size()])) return *found;
  }
}
/// One that filters decide, mostly.
template <Real T, template <class> class Shape>
std::pair<Ray<T>, Shape<T>> draw_plain(Random& random) {
  for (const Family& family = *find_family("random");;) {
    if (auto found = draw_of<T, Shape>(random, family)) return *found;
  }
}

template <Real T>
void nudge(Random& random, T& x) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  x = std::nextafter(x, random.one_in(2) ? infinity : -infinity);
}

template <Real T>
T& component(Vec3<T>& v, std::uint64_t k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

template <Real T>
void vary(Random& random, Triangle<T>& triangle) {
  switch (random.below(4)) {
    case 0:
      triangle = {triangle.b, triangle.c, triangle.a};
      break;
    case 1:
      std::swap(triangle.b, triangle.c);
      break;
    case 2:
      nudge(random, component(triangle.a, random.below(3)));
      break;
    default:
      break;
  }
}
template <Real T>
void vary(Random& random, Sphere<T>& sphere) {
  switch (random.below(4)) {
    case 0:
      nudge(random, sphere.radius);
      break;
    case 1:
      nudge(random, component(sphere.center, random.below(3)));
      break;
    default:
      break;
  }
}
template <Real T>
void vary(Random& random, Ray<T>& ray) {
  switch (random.below(6)) {
    case 0:
      ray.direction = {-ray.direction.x, -ray.direction.y, -ray.direction.z};
      break;
    case 1:
      nudge(random, component(ray.origin, random.below(3)));
      break;
    case 2:
      nudge(random, component(ray.direction, random.below(3)));
      break;
    case 3:
      nudge(random, ray.t_min);
      break;
    default:
      break;
  }
}

/// Short ones mostly: ends are where batches fail.
std::size_t random_length(Random& random, std::size_t longest) {
  const std::size_t limit = random.one_in(512) ? longest : random.one_in(16) ? 80 : 8;
  return random.below(std::min(limit, longest) + 1);
}

template <Real T>
void make_invalid(Sphere<T>& sphere) {
  sphere.radius = -sphere.radius;
}
template <Real T>
void make_invalid(Triangle<T>& triangle) {
  triangle.c.z = std::numeric_limits<T>::infinity();
}

/// One ray and some words of shapes that filters decide, but for one at most.
template <Real T, template <class> class Shape>
Batch<T, Shape> plain_batch(Random& random, std::size_t longest) {
  Batch<T, Shape> batch{BatchForm::one_ray, FloatMode::nearest, random.below(16), {}, {}};
  batch.rays.push_back(draw_plain<T, Shape>(random).first);
  const std::size_t n = std::min<std::size_t>(64 + random.below(512), longest);
  for (std::size_t i = 0; i < n; ++i) batch.shapes.push_back(draw_plain<T, Shape>(random).second);
  if (n == 0) return batch;
  Shape<T>& odd = batch.shapes[random.below(n)];
  switch (random.below(3)) {
    case 0:
      make_invalid(odd);
      break;
    case 1:
      odd = draw<T, Shape>(random, random.below(families().size())).second;
      break;
    default:
      break;
  }
  return batch;
}

}  // namespace

template <Real T, template <class> class Shape>
Batch<T, Shape> random_batch(Random& random, std::size_t longest) {
  if (random.one_in(128)) return plain_batch<T, Shape>(random, longest);
  Batch<T, Shape> batch;
  batch.form = static_cast<BatchForm>(random.below(3));
  batch.mode = float_modes[random.below(float_modes.size())];
  batch.offset = random.below(16);
  const std::size_t n = random_length(random, longest), family = random.below(families().size());
  const auto [ray, shape] = draw<T, Shape>(random, family);
  // Half of the batches ask for ranges only where their first ray does.
  const bool keeps_range = random.one_in(2);
  for (std::size_t i = 0; i < n; ++i) {
    auto lane = random.one_in(2) ? std::pair{ray, shape} : draw<T, Shape>(random, random.one_in(4) ? random.below(99) : family);
    if (random.one_in(2)) vary(random, lane.first);
    if (random.one_in(2)) vary(random, lane.second);
    if (keeps_range) lane.first.t_min = ray.t_min, lane.first.t_max = ray.t_max;
    if (batch.form != BatchForm::one_ray) batch.rays.push_back(lane.first);
    if (batch.form != BatchForm::one_shape) batch.shapes.push_back(lane.second);
  }
  if (batch.form == BatchForm::one_ray) batch.rays.push_back(ray);
  if (batch.form == BatchForm::one_shape) batch.shapes.push_back(shape);
  return batch;
}

template Batch<float, Triangle> random_batch(Random&, std::size_t);
template Batch<double, Triangle> random_batch(Random&, std::size_t);
template Batch<float, Sphere> random_batch(Random&, std::size_t);
template Batch<double, Sphere> random_batch(Random&, std::size_t);

}  // namespace graze::fuzz
