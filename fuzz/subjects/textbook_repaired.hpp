// The quadratic without cancellation, with the hole at B = 0 closed.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook/sphere.hpp"

namespace graze::fuzz::textbook_repaired {

struct Formula {
  static constexpr std::string_view name = "textbook-repaired";
  static constexpr std::string_view about =
      "q = -(B + sgn(B) sqrt(D)) / 2, t = q/A and C/q, sgn(0) = 1; Press et al., Numerical Recipes, 5.6, mended at B = 0";

  static constexpr Deviations deviations{{Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    return textbook::repaired::intersect(query.ray, query.sphere);
  }
};

}  // namespace graze::fuzz::textbook_repaired
