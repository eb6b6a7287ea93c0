#include "fuzz/subject.hpp"

#include <array>

#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {

std::span<const Subject* const> subjects() {
  static const std::array all = {
    &graze_subject(),
    &textbook_naive_subject(),
    &textbook_stable_subject(),
    &textbook_repaired_subject(),
    &haines_sphere_subject(),
    &goualard_quadratic_subject(),
    &pbrt_interval_subject(),
    &cramer_subject(),
    &moller_trumbore_subject(),
    &woop_watertight_subject(),
    &cgal_epick_subject(),
#if GRAZE_HAVE_EMBREE
    &embree_subject(),
    &embree_robust_subject(),
#endif
  };
  return all;
}

namespace {

template <Real T>
void answer_each(const Subject& subject, std::span<const Case<T>> inputs, std::span<Reply<T>> replies) {
  for (std::size_t i = 0; i < inputs.size(); ++i) replies[i] = subject.answer(inputs[i]);
}

}  // namespace

void Subject::answer(std::span<const Case<float>> inputs, std::span<Reply<float>> replies) const {
  answer_each(*this, inputs, replies);
}
void Subject::answer(std::span<const Case<double>> inputs, std::span<Reply<double>> replies) const {
  answer_each(*this, inputs, replies);
}

const Subject* find_subject(std::string_view name) {
  for (const Subject* subject : subjects()) {
    if (subject->name() == name) return subject;
  }
  return nullptr;
}

}  // namespace graze::fuzz
