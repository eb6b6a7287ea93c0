#include "fuzz/subjects/cgal_epick.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& cgal_epick_subject() {
  static const FormulaSubject<cgal_epick::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
