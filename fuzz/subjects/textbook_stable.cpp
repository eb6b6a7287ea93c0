#include "fuzz/subjects/textbook_stable.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& textbook_stable_subject() {
  static const FormulaSubject<textbook_stable::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
