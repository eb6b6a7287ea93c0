// A point against a triangle: on it, and whether the way from the point along +x crosses it. Exact.
#pragma once

#include "graze/types.hpp"

namespace graze::exact {

/// Whether the point belongs to the triangle, edges and corners included; it may be degenerate. All is finite.
template <Real T>
[[nodiscard]] bool is_on(const Vec3<T>& point, const Triangle<T>& triangle) noexcept;

/// Whether { p' + t (1, 0, 0) : t > 0 } crosses the triangle for p' = point + (0, e, e^2) and every e > 0 that is small enough
/// (Edelsbrunner & Muecke 1990, simulation of simplicity). Such a line meets no edge, so of the triangles about an edge or a
/// corner just as many are crossed as by a line beside it. The point is not on the triangle; all is finite.
template <Real T>
[[nodiscard]] bool is_crossed(const Vec3<T>& point, const Triangle<T>& triangle) noexcept;

}  // namespace graze::exact
