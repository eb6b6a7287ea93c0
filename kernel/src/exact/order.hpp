// Exact decisions without numbers, and the exact order of hits along a ray by their first values.
#pragma once

#include "graze/answer.hpp"

namespace graze::exact {

struct TriangleDecision {
  TriangleKind kind;
  Facing facing;
};

/// The kind and the side, nothing rounded. The input is valid.
template <Real T>
[[nodiscard]] TriangleDecision decide(const Ray<T>& ray, const Triangle<T>& triangle) noexcept;

/// low <= value <= high; each is normal, zero or infinite.
struct Enclosure {
  double low, high;
};

/// About the exact first value of a shape that the ray meets, to 2^-52 of it or better.
template <Real T, template <class> class Shape>
[[nodiscard]] Enclosure enclose_first(const Ray<T>& ray, const Shape<T>& shape) noexcept;

/// The sign of one first value minus the other's, both shapes being met by the ray. Exact.
template <Real T, template <class> class One, template <class> class Other>
[[nodiscard]] int compare_first(const Ray<T>& ray, const One<T>& one, const Other<T>& other) noexcept;

}  // namespace graze::exact
