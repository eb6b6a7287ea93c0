#include "fuzz/subject.hpp"

#include <array>

#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

std::span<const Subject* const> subjects() {
  static const std::array<const Subject*, 6> all = {&graze_subject(),           &textbook_naive_subject(),
                                                    &textbook_stable_subject(), &textbook_repaired_subject(),
                                                    &cramer_subject(),          &moller_trumbore_subject()};
  return all;
}

const Subject* find_subject(std::string_view name) {
  for (const Subject* subject : subjects()) {
    if (subject->name() == name) return subject;
  }
  return nullptr;
}

}  // namespace graze::fuzz
