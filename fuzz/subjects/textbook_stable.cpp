// The quadratic without cancellation, and with its hole at B = 0.
#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"
#include "graze/textbook/sphere.hpp"

namespace graze::fuzz {
namespace {

struct Stable {
  static constexpr std::string_view name = "textbook-stable";
  static constexpr std::string_view about =
      "q = -(B + sgn(B) sqrt(D)) / 2, t = q/A and C/q, sgn(0) = 0; Press et al., Numerical Recipes, 5.6";

  static constexpr Deviations deviations{{Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    return textbook::stable::intersect(query.ray, query.sphere);
  }
};

}  // namespace

const Subject& textbook_stable_subject() {
  static const FormulaSubject<Stable> subject;
  return subject;
}

}  // namespace graze::fuzz
