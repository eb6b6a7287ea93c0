// Ray and triangle by Cramer's rule.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook/triangle.hpp"

namespace graze::fuzz::cramer {

struct Formula {
  static constexpr std::string_view name = "cramer";
  static constexpr std::string_view about =
      "Cramer's rule on the 3x3 system in u, v, t; Shirley, Marschner, Fundamentals of Computer Graphics, 4.4.2";

  static constexpr Deviations deviations{
      {Deviation::coplanar_is_miss, Deviation::degenerate_is_miss, Deviation::invalid_unhandled}};

  template <Real T>
  static TriangleHit<T> answer(const RayTriangle<T>& query) {
    return textbook::cramer::intersect(query.ray, query.triangle);
  }
};

}  // namespace graze::fuzz::cramer
