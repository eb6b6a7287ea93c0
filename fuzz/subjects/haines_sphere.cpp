#include "fuzz/subjects/haines_sphere.hpp"

#include "fuzz/subjects/formula_subject.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

const Subject& haines_sphere_subject() {
  static const FormulaSubject<haines_sphere::Formula> subject;
  return subject;
}

}  // namespace graze::fuzz
