// A subject made of overloads: one static function `answer` for each query that the formula offers.
#pragma once

#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Formula has `name` and `about` and, for each query type Q<T> that it offers, a static `answer(const Q<T>&)` that returns
/// SphereHit<T>, TriangleHit<T> or Side. What it has no overload for is answered by nullopt.
template <class Formula>
class FormulaSubject final : public Subject {
 public:
  [[nodiscard]] std::string_view name() const override { return Formula::name; }
  [[nodiscard]] std::string_view about() const override { return Formula::about; }
  [[nodiscard]] std::optional<Answer<float>> answer(const Case<float>& input) const override { return visit_case(input); }
  [[nodiscard]] std::optional<Answer<double>> answer(const Case<double>& input) const override { return visit_case(input); }

 private:
  template <Real T>
  static std::optional<Answer<T>> visit_case(const Case<T>& input) {
    return std::visit(
        [](const auto& query) -> std::optional<Answer<T>> {
          if constexpr (requires { Formula::answer(query); }) {
            return Formula::answer(query);
          } else {
            return std::nullopt;
          }
        },
        input);
  }
};

}  // namespace graze::fuzz
