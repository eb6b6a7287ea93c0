// Inside or outside a closed surface, by the parity of the crossings of one way out.
#include "exact/parity.hpp"
#include "graze/implicit.hpp"
#include "scene/parallel.hpp"
#include "scene/walk.hpp"

namespace graze {
namespace scene {
namespace {

/// Along +x. A primitive that the point is on, or a sphere that holds it, is met by that ray too, so its leaf is visited.
template <Real T, class Tally>
[[nodiscard]] Place inside(const Data<T>& data, const Vec3<T>& point, Tally tally) noexcept {
  using predicates::TriangleVerdict;
  if (!data.is_closed || !numeric::is_finite(point)) return Place::unknown;
  const Ray<T> ray{point, {T(1), T(0), T(0)}};
  const QueryOptions options;
  const Query<T, Tally> query(data, ray, options, tally);
  BoxRay box = box_ray(data.space, data.root, ray);
  bool is_inside = false, is_on = false;
  walk(query, box, [&](Child leaf) {
    if (leaf.is_spheres()) {
      const SphereBlock<T>& block = data.spheres[leaf.index()];
      for (int i = 0; i < width && block.index[i] != no_primitive && !is_on; ++i) {
        tally.template add<&Statistics::sphere_tests>(1);
        const Sign sign = side(point, block.sphere(i)).sign;
        is_on = sign == Sign::zero;
        is_inside ^= sign == Sign::negative;
      }
      return is_on;
    }
    const TriangleBlock<T>& block = data.triangles[leaf.index()];
    for (int i = 0; i < width && block.index[i] != no_primitive; ++i) {
      const Triangle<T> triangle = block.triangle(i);
      tally.template add<&Statistics::triangle_tests>(1);
      tally.template add<&Statistics::error_bounds>(1);
      // A certain verdict holds for the perturbed ray too, and for the point itself: it is an end of the ray.
      const TriangleVerdict verdict = predicates::verdict(predicates::triangle_terms<double>(ray, triangle), ray);
      if (verdict != TriangleVerdict::uncertain) {
        is_inside ^= verdict == TriangleVerdict::face;
        continue;
      }
      tally.template add<&Statistics::exact_decisions>(1);
      if (exact::is_on(point, triangle)) return is_on = true;
      is_inside ^= exact::is_crossed(point, triangle);
    }
    return false;
  });
  return is_on ? Place::boundary : is_inside ? Place::inside : Place::outside;
}

}  // namespace
}  // namespace scene

template <Real T>
Place Scene<T>::inside(const Vec3<T>& point) const noexcept {
  return scene::inside(*data_, point, scene::Silent{});
}
template <Real T>
Place Scene<T>::inside(const Vec3<T>& point, Statistics& statistics) const noexcept {
  return scene::inside(*data_, point, scene::Counting{statistics});
}
template <Real T>
void Scene<T>::inside(std::span<const Vec3<T>> points, std::span<Place> answers, Threads threads) const {
  scene::for_ranges(std::min(points.size(), answers.size()), 64, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = inside(points[i]);
  });
}

#define GRAZE_INSIDE(T)                                                        \
  template Place Scene<T>::inside(const Vec3<T>&) const noexcept;              \
  template Place Scene<T>::inside(const Vec3<T>&, Statistics&) const noexcept; \
  template void Scene<T>::inside(std::span<const Vec3<T>>, std::span<Place>, Threads) const;
GRAZE_INSIDE(float)
GRAZE_INSIDE(double)
#undef GRAZE_INSIDE

}  // namespace graze
