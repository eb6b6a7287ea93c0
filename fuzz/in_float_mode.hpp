// A subject that is called in a floating-point mode of its own.
#pragma once

#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// The other subject, each of its calls in that mode. For those that answer in this process. Refers to the other.
class InFloatMode final : public Subject {
 public:
  InFloatMode(const Subject& other, FloatMode mode) : other_(other), mode_(mode) {}

  [[nodiscard]] std::string_view name() const override { return other_.name(); }
  [[nodiscard]] std::string_view about() const override { return other_.about(); }
  [[nodiscard]] const Deviations& deviations() const override { return other_.deviations(); }
  [[nodiscard]] FloatMode float_mode() const override { return mode_; }
  [[nodiscard]] bool is_for_all_modes() const override { return other_.is_for_all_modes(); }
  [[nodiscard]] std::string_view options() const override { return other_.options(); }
  [[nodiscard]] Reply<float> answer(const Case<float>& input) const override { return in_mode(input); }
  [[nodiscard]] Reply<double> answer(const Case<double>& input) const override { return in_mode(input); }
  // To set a mode takes as long as many a call.
  void answer(std::span<const Case<float>> inputs, std::span<Reply<float>> replies) const override {
    const FloatModeScope scope(mode_);
    other_.answer(inputs, replies);
  }
  void answer(std::span<const Case<double>> inputs, std::span<Reply<double>> replies) const override {
    const FloatModeScope scope(mode_);
    other_.answer(inputs, replies);
  }

 private:
  template <Real T>
  Reply<T> in_mode(const Case<T>& input) const {
    const FloatModeScope scope(mode_);
    return other_.answer(input);
  }

  const Subject& other_;
  FloatMode mode_;
};

}  // namespace graze::fuzz
