// Ray and sphere by Haines, Guenther and Akenine-Moeller, "Precision improvements for ray/sphere intersection", Ray Tracing
// Gems, chapter 7, 2019: the discriminant from what is left of the center's offset when its part along the ray is taken off, so
// that a far and small sphere is not lost in the difference of two large squares; the roots without cancellation. Fails near
// tangents, where the remainder's square and r^2 agree in more digits than the format has; where squares under- or overflow;
// and where the origin lies on the sphere or near it, for c = f.f - r^2 cancels and its root with it.
#pragma once

#include <cmath>
#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook/sphere.hpp"

namespace graze::fuzz::haines_sphere {

struct Formula {
  static constexpr std::string_view name = "haines-sphere";
  static constexpr std::string_view about =
      "D = r^2 - |f + (b/a) d|^2, roots c/q and q/a; Haines, Guenther, Akenine-Moeller, Ray Tracing Gems, chapter 7";
  static constexpr Deviations deviations{{Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    const Ray<T>& ray = query.ray;
    const T r = query.sphere.radius;
    const Vec3<T> f = textbook::difference(ray.origin, query.sphere.center);
    const T a = textbook::dot(ray.direction, ray.direction);
    const T b = -textbook::dot(f, ray.direction);
    const T along = b / a;
    const Vec3<T> remainder{f.x + along * ray.direction.x, f.y + along * ray.direction.y, f.z + along * ray.direction.z};
    const T discriminant = r * r - textbook::dot(remainder, remainder);
    const T c = textbook::dot(f, f) - r * r;
    SphereHit<T> hit;
    hit.origin = c < 0 ? OriginSide::inside : c > 0 ? OriginSide::outside : OriginSide::on;
    if (!(discriminant >= 0)) return hit;
    if (discriminant == 0) return textbook::detail::hit_of_double_root(ray, hit.origin, along);
    const T root = std::sqrt(a * discriminant);
    const T q = b < 0 ? b - root : b + root;
    return textbook::detail::hit_of_roots(ray, hit.origin, textbook::detail::ascending(c / q, q / a));
  }
};

}  // namespace graze::fuzz::haines_sphere
