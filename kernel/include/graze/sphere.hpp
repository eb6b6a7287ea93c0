// Ray and sphere: the exact kind, the side of the origin and the correctly rounded roots, or the decision alone.
//
// The same bits from every compiler, flag, rounding mode, and with flush-to-zero or denormals-are-zero on: the filter's bounds
// hold in all of them, the rounding stage looks at the rounding mode first and leaves a directed one to the exact stage, and
// the exact stage is integers from the bits of the input. No mode is ever changed. Floating-point traps must be off; the sticky
// exception flags may be raised.
#pragma once

#include "graze/answer.hpp"
#include "graze/predicates/sphere_filter.hpp"

namespace graze {

namespace rounding {
/// The roots that the verdict names, from double-double; exact where those are in doubt. Compiled in the library.
template <Real T>
[[nodiscard]] SphereHit<T> roots(const Ray<T>& ray, const Sphere<T>& sphere, const predicates::SphereTerms<double>& terms,
                                 const predicates::SphereVerdict& verdict) noexcept;
}  // namespace rounding

namespace exact {
/// The whole answer by exact integers, invalid input included. Compiled in the library.
template <Real T>
[[nodiscard]] SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept;
template <Real T>
[[nodiscard]] bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept;
}  // namespace exact

namespace predicates {
/// `hits` where the filter in double is in doubt: by short integers where these hold the input, else by `exact`. Compiled in
/// the library.
template <Real T>
[[nodiscard]] bool hits_in_doubt(const Ray<T>& ray, const Sphere<T>& sphere) noexcept;
/// `hits` where the filter in float is in doubt: the filter in double, then the former. Compiled in the library.
[[nodiscard]] bool hits_in_double(const Ray<float>& ray, const Sphere<float>& sphere) noexcept;
}  // namespace predicates

/// Where the ray meets the sphere. The kind is exact, every number is correctly rounded, any input is answered; nothing is
/// thrown, allocated or kept.
template <Real T>
[[nodiscard]] inline SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  if (!predicates::is_plain<double>(ray, sphere)) return exact::intersect(ray, sphere);
  predicates::SphereTerms<double> terms = predicates::sphere_terms<double>(ray, sphere);
  const predicates::SphereVerdict verdict = predicates::verdict(terms, ray, sphere);
  if (verdict.kind == SphereKind::miss) {
    SphereHit<T> hit;
    hit.origin = verdict.origin;
    return hit;
  }
  if (verdict.kind == SphereKind::secant) return rounding::roots(ray, sphere, terms, verdict);
  return exact::intersect(ray, sphere);
}

/// Whether `intersect` would find a common point: false for a miss and for invalid input. Exact, and cheaper.
template <Real T>
[[nodiscard]] inline bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  predicates::SphereTerms<T> terms = predicates::sphere_terms<T>(ray, sphere);
  const predicates::SphereVerdict verdict = predicates::verdict(terms, ray, sphere);
  if (verdict.kind != SphereKind::invalid) return verdict.kind == SphereKind::secant;
  if constexpr (sizeof(T) < sizeof(double)) {
    return predicates::hits_in_double(ray, sphere);
  } else {
    return predicates::hits_in_doubt(ray, sphere);
  }
}

}  // namespace graze
