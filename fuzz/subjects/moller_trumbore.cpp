// Ray and triangle by Moeller and Trumbore.
#include "fuzz/subjects/moller_trumbore.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {
namespace {

struct MollerTrumbore {
  static constexpr std::string_view name = "moller-trumbore";
  static constexpr std::string_view about =
      "Moeller, Trumbore, Fast, minimum storage ray/triangle intersection, JGT 2(1) 1997; two-sided, no epsilon";

  static constexpr Deviations deviations{
      {Deviation::coplanar_is_miss, Deviation::degenerate_is_miss, Deviation::invalid_unhandled}};

  template <Real T>
  static TriangleHit<T> answer(const RayTriangle<T>& query) {
    return moller_trumbore::intersect(query.ray, query.triangle);
  }
};

}  // namespace

const Subject& moller_trumbore_subject() {
  static const FormulaSubject<MollerTrumbore> subject;
  return subject;
}

}  // namespace graze::fuzz
