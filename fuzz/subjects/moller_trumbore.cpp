#include "fuzz/subjects/moller_trumbore.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& moller_trumbore_subject() {
  static const FormulaSubject<moller_trumbore::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
