#include "fuzz/subjects/cramer.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& cramer_subject() {
  static const FormulaSubject<cramer::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
