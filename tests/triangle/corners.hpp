// The triangle that most is computed on by hand, and triangles with their corners in other orders.
#pragma once

#include <array>

#include "graze/types.hpp"

namespace graze::test {

/// u and v are a quarter of x and y.
template <Real T>
inline constexpr Triangle<T> right{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

/// Its corners in all six orders.
template <Real T>
[[nodiscard]] std::array<Triangle<T>, 6> all_orders(const Triangle<T>& triangle) {
  const auto& [a, b, c] = triangle;
  return {{{a, b, c}, {b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}};
}

}  // namespace graze::test
