#include "fuzz/subjects/textbook_naive.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& textbook_naive_subject() {
  static const FormulaSubject<textbook_naive::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
