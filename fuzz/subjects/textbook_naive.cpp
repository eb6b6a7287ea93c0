// The formulas as they are taught first.
#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"
#include "graze/textbook.hpp"

namespace graze::fuzz {
namespace {

/// The side by the computed f; a NaN counts as on the surface, for no comparison tells otherwise.
template <Real T>
Side side_of(T f) {
  return {Status::ok, f < 0 ? Sign::negative : f > 0 ? Sign::positive : Sign::zero};
}

struct Naive {
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

}  // namespace

const Subject& textbook_naive_subject() {
  static const FormulaSubject<Naive> subject;
  return subject;
}

}  // namespace graze::fuzz
