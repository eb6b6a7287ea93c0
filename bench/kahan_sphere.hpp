// Ray and sphere by the textbook's quadratic without cancellation, but with Kahan's discriminant ("On the cost of
// floating-point computation without extra-precise arithmetic", 2004): the rounding errors of both products by fused
// multiply-adds. Fails where the coefficients themselves are rounded: far from a small sphere, near a tangent.
#pragma once

#include "fuzz/subjects/goualard_quadratic.hpp"
#include "graze/textbook/sphere.hpp"

namespace graze::bench::kahan_sphere {

struct Formula {
  static constexpr std::string_view name = "kahan-discriminant";
  static constexpr std::string_view about = "the stable quadratic with Kahan's discriminant by fused multiply-adds";
  static constexpr fuzz::Deviations deviations{{fuzz::Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const fuzz::RaySphere<T>& query) {
    const textbook::Quadratic<T> q = textbook::quadratic(query.ray, query.sphere);
    SphereHit<T> hit;
    hit.origin = q.c < 0 ? OriginSide::inside : q.c > 0 ? OriginSide::outside : OriginSide::on;
    const T d = fuzz::goualard_quadratic::kahan_discriminant(q.a, q.b, q.c);
    if (!(d >= 0)) return hit;
    if (d == 0) return textbook::detail::hit_of_double_root(query.ray, hit.origin, -q.b / (2 * q.a));
    const T shared = -(q.b + textbook::repaired::sgn(q.b) * std::sqrt(d)) / 2;
    return textbook::detail::hit_of_roots(query.ray, hit.origin, textbook::detail::ascending(shared / q.a, q.c / shared));
  }
};

}  // namespace graze::bench::kahan_sphere
