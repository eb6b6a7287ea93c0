#include "fuzz/subjects/goualard_quadratic.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& goualard_quadratic_subject() {
  static const FormulaSubject<goualard_quadratic::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
