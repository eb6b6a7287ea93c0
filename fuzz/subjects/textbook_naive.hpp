// The formulas as they are taught first.
#pragma once

#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook.hpp"

namespace graze::fuzz::textbook_naive {

/// The side by the computed f; a NaN counts as on the surface, for no comparison tells otherwise.
template <Real T>
Side side_of(T f) {
  return {Status::ok, f < 0 ? Sign::negative : f > 0 ? Sign::positive : Sign::zero};
}

struct Formula {
  static constexpr std::string_view name = "textbook-naive";
  static constexpr std::string_view about =
      "t = (-B -+ sqrt(B^2 - 4AC)) / 2A and the sign of f(p); Shirley, Marschner, Fundamentals of Computer Graphics, 4.4.1";

  static constexpr Deviations deviations{{Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    return textbook::naive::intersect(query.ray, query.sphere);
  }
  template <Real T>
  static Side answer(const PointLine<T>& query) {
    return side_of(textbook::f(query.point, query.line));
  }
  template <Real T>
  static Side answer(const PointPlane<T>& query) {
    return side_of(textbook::f(query.point, query.plane));
  }
  template <Real T>
  static Side answer(const PointSphere<T>& query) {
    return side_of(textbook::f(query.point, query.sphere));
  }
};

}  // namespace graze::fuzz::textbook_naive
