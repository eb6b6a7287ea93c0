// The kernel itself under test: all that it offers for a case.
#include "fuzz/kernel_calls.hpp"
#include "fuzz/subjects/subjects.hpp"

namespace graze::fuzz {
namespace {

class Kernel final : public Subject {
 public:
  [[nodiscard]] std::string_view name() const override { return "graze"; }
  [[nodiscard]] std::string_view about() const override { return "this library: exact decisions, correctly rounded numbers"; }
  [[nodiscard]] const Deviations& deviations() const override {
    static constexpr Deviations none;
    return none;
  }
  [[nodiscard]] bool is_for_all_modes() const override { return true; }
  using Subject::answer;
  [[nodiscard]] Reply<float> answer(const Case<float>& input) const override { return reply(input); }
  [[nodiscard]] Reply<double> answer(const Case<double>& input) const override { return reply(input); }

 private:
  /// The decision alone has to be that of the full answer.
  template <Real T>
  static Reply<T> reply(const Case<T>& input) {
    const KernelAnswer<T> both = kernel_answer(input);
    if (both.hits == is_hit(both.answer)) return both.answer;
    return Reply<T>::failed(both.hits ? "contradicts itself: hits() is true, intersect() tells no hit"
                                      : "contradicts itself: hits() is false, intersect() tells a hit");
  }
};

}  // namespace

const Subject& graze_subject() {
  static const Kernel subject;
  return subject;
}

}  // namespace graze::fuzz
