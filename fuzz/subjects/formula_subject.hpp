// A subject made of overloads: one static function `answer` for each query that the formula offers.
#pragma once

#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Formula has `name` and `about` and, for each query type Q<T> that it offers, a static `answer(const Q<T>&)` that returns
/// SphereHit<T>, TriangleHit<T> or Side, or a Reply<T>. What it has no overload for is not offered. It may have `deviations`.
template <class Formula>
class FormulaSubject final : public Subject {
 public:
  [[nodiscard]] std::string_view name() const override { return Formula::name; }
  [[nodiscard]] std::string_view about() const override { return Formula::about; }
  [[nodiscard]] const Deviations& deviations() const override {
    if constexpr (requires { Formula::deviations; }) {
      return Formula::deviations;
    } else {
      static constexpr Deviations none;
      return none;
    }
  }
  using Subject::answer;
  [[nodiscard]] Reply<float> answer(const Case<float>& input) const override { return visit_case(input); }
  [[nodiscard]] Reply<double> answer(const Case<double>& input) const override { return visit_case(input); }

 private:
  template <Real T>
  static Reply<T> visit_case(const Case<T>& input) {
    return std::visit(
        [](const auto& query) -> Reply<T> {
          if constexpr (requires { Formula::answer(query); }) {
            if constexpr (std::same_as<decltype(Formula::answer(query)), Reply<T>>) {
              return Formula::answer(query);
            } else {
              return Answer<T>(Formula::answer(query));
            }
          } else {
            return std::nullopt;
          }
        },
        input);
  }
};

}  // namespace graze::fuzz
