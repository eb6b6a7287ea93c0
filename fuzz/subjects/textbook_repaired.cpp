#include "fuzz/subjects/textbook_repaired.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& textbook_repaired_subject() {
  static const FormulaSubject<textbook_repaired::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
