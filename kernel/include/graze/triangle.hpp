// Ray and triangle: the exact kind and the correctly rounded t, u, v, or the decision alone.
//
// The same bits from every compiler, flag, rounding mode, and with flush-to-zero or denormals-are-zero on: the filter's bounds
// hold in all of them, the rounding stage looks at the rounding mode first and leaves a directed one to the exact stage, and
// the exact stage is integers from the bits of the input. No mode is ever changed. Floating-point traps must be off; the sticky
// exception flags may be raised.
#pragma once

#include "graze/answer.hpp"
#include "graze/predicates/triangle_filter.hpp"

namespace graze {

namespace rounding {
/// The numbers of a hit inside the face, from double-double; exact where those are in doubt. Compiled in the library.
template <Real T>
[[nodiscard]] TriangleHit<T> face(const Ray<T>& ray, const Triangle<T>& triangle,
                                  const predicates::TriangleTerms<double>& terms) noexcept;
}  // namespace rounding

namespace exact {
/// The whole answer by exact integers, invalid input included. Compiled in the library.
template <Real T>
[[nodiscard]] TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle) noexcept;
template <Real T>
[[nodiscard]] bool hits(const Ray<T>& ray, const Triangle<T>& triangle) noexcept;
}  // namespace exact

namespace predicates {
/// `hits` where the filter in double is in doubt: by short integers where these hold the input, else by `exact`. Compiled in
/// the library.
template <Real T>
[[nodiscard]] bool hits_in_doubt(const Ray<T>& ray, const Triangle<T>& triangle) noexcept;
/// `hits` where the filter in float is in doubt: the filter in double, then the former. Compiled in the library.
[[nodiscard]] bool hits_in_double(const Ray<float>& ray, const Triangle<float>& triangle) noexcept;
}  // namespace predicates

/// Where the ray meets the triangle. The kind is exact, every number is correctly rounded, any input is answered; nothing is
/// thrown, allocated or kept.
template <Real T>
[[nodiscard]] inline TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using predicates::TriangleVerdict;
  if (!numeric::is_default_range(ray) && !numeric::is_ordinary_range<double>(ray)) return exact::intersect(ray, triangle);
  const predicates::TriangleTerms<double> terms = predicates::triangle_terms<double>(ray, triangle);
  const TriangleVerdict verdict = predicates::verdict(terms, ray);
  if (verdict == TriangleVerdict::miss) {
    TriangleHit<T> hit;
    hit.facing = terms.is_front ? Facing::front : Facing::back;
    return hit;
  }
  if (verdict == TriangleVerdict::face) return rounding::face(ray, triangle, terms);
  return exact::intersect(ray, triangle);
}

/// Whether `intersect` would find a common point: false for a miss and for invalid input. Exact, and cheaper.
template <Real T>
[[nodiscard]] inline bool hits(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using predicates::TriangleVerdict;
  const TriangleVerdict verdict = predicates::verdict(predicates::triangle_terms<T>(ray, triangle), ray);
  if (verdict != TriangleVerdict::uncertain) return verdict == TriangleVerdict::face;
  if constexpr (sizeof(T) < sizeof(double)) {
    return predicates::hits_in_double(ray, triangle);
  } else {
    return predicates::hits_in_doubt(ray, triangle);
  }
}

}  // namespace graze
