#include "fuzz/subjects/woop_watertight.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& woop_watertight_subject() {
  static const FormulaSubject<woop_watertight::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
