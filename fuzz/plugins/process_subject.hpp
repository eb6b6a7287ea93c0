// A kernel in processes of its own: whatever it does, the certifier goes on.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fuzz/plugins/declaration.hpp"
#include "fuzz/plugins/process.hpp"
#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// Speaks the case protocol with processes. Where one fails on a batch, new ones are asked parts of it, down to single cases,
/// so that the failure is told of the case at fault and of no other.
class ProcessSubject final : public Subject {
 public:
  struct Settings {
    std::string name, about;
    Declaration declaration;
    std::array<std::vector<std::string>, 2> commands;  ///< for float and for double
    /// A process that stays writes a line for each case that it has read, at once, and is asked again, one process for each
    /// thread that asks. One that does not is given a batch and the end of its input, and has to end itself: only then are its
    /// lines known to be all, and it need not flush.
    bool stays = false;
    double time_limit = 2;                ///< seconds for an answer
    FloatMode mode = FloatMode::nearest;  ///< in which the commands ask the kernel
    std::string options;                  ///< of the command line that opened it
  };
  /// After so many cases that hung, the rest is not asked any more and has failed.
  static constexpr int most_hangs = 20;

  explicit ProcessSubject(Settings settings) : settings_(std::move(settings)) {}

  [[nodiscard]] std::string_view name() const override { return settings_.name; }
  [[nodiscard]] std::string_view about() const override { return settings_.about; }
  [[nodiscard]] const Deviations& deviations() const override { return settings_.declaration.deviations; }
  [[nodiscard]] FloatMode float_mode() const override { return settings_.mode; }
  [[nodiscard]] std::string_view options() const override { return settings_.options; }
  [[nodiscard]] Reply<float> answer(const Case<float>& input) const override { return answer_one(input); }
  [[nodiscard]] Reply<double> answer(const Case<double>& input) const override { return answer_one(input); }
  void answer(std::span<const Case<float>> inputs, std::span<Reply<float>> replies) const override {
    answer_all(inputs, replies);
  }
  void answer(std::span<const Case<double>> inputs, std::span<Reply<double>> replies) const override {
    answer_all(inputs, replies);
  }

 private:
  /// How a batch failed.
  struct Failure {
    std::string how;        ///< a clause; empty where it did not
    std::size_t place = 0;  ///< the case that seems to be at fault
    bool is_hang = false;
  };
  template <Real T>
  Reply<T> answer_one(const Case<T>& input) const;
  template <Real T>
  void answer_all(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const;
  /// Asks for all, and where that fails for ever smaller parts; false where some case has no answer.
  template <Real T>
  bool answer_parts(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const;
  /// Asks one process for all.
  template <Real T>
  Failure answer_at_once(std::span<const Case<T>> inputs, std::span<Reply<T>> replies) const;

  /// A process that waits, or a new one; where none can be started, why.
  [[nodiscard]] std::unique_ptr<Process> take(std::size_t precision, std::string& wrong) const;
  void give_back(std::size_t precision, std::unique_ptr<Process> process) const;

  Settings settings_;
  mutable std::mutex mutex_;
  mutable std::array<std::vector<std::unique_ptr<Process>>, 2> waiting_;
  mutable std::atomic<int> hangs_{0};
  mutable std::atomic<std::size_t> most_at_once_{std::size_t{1} << 16};  ///< less for a kernel that is slow
};

}  // namespace graze::fuzz
