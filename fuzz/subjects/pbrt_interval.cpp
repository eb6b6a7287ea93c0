#include "fuzz/subjects/pbrt_interval.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& pbrt_interval_subject() {
  static const FormulaSubject<pbrt_interval::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
