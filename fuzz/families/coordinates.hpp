// The numbers of a case by position, and its ray if it has one.
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "fuzz/case_numbers.hpp"

namespace graze::fuzz::construct {

/// Pointers to the numbers of a case, in the order of its case line; the ends of a ray's range come after the others,
/// uncounted.
template <Real T>
struct Coordinates {
  std::array<T*, 17> at{};
  std::size_t count = 0;
  std::size_t radius = 17;  ///< which one is a radius; 17 if none
};

template <Real T>
Coordinates<T> coordinates(Case<T>& input) {
  Coordinates<T> all;
  std::visit(
      [&](auto& query) {
        for_each_number(query, [&](T& number) { all.at[all.count++] = &number; });
        if constexpr (requires { query.ray; }) all.count -= 2;
        if constexpr (requires { query.sphere; }) all.radius = all.count - 1;
      },
      input);
  return all;
}

template <Real T>
Ray<T>* ray_of(Case<T>& input) {
  if (auto* sphere_case = std::get_if<RaySphere<T>>(&input)) return &sphere_case->ray;
  if (auto* triangle_case = std::get_if<RayTriangle<T>>(&input)) return &triangle_case->ray;
  return nullptr;
}

}  // namespace graze::fuzz::construct
