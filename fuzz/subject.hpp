// A subject: a kernel under test, ours or another's, behind one interface.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "fuzz/float_mode.hpp"

namespace graze::fuzz {

/// What comes back for a case: an answer; nothing, where the query is not offered; or how the subject failed.
template <Real T>
class Reply {
 public:
  Reply() = default;
  Reply(std::nullopt_t) {}
  Reply(Answer<T> answer) : answer_(std::move(answer)) {}
  static Reply failed(std::string how) {
    Reply reply;
    reply.failure_ = std::move(how);
    return reply;
  }

  explicit operator bool() const { return answer_.has_value(); }
  [[nodiscard]] const Answer<T>& operator*() const { return *answer_; }
  /// Empty unless the subject crashed, hung, or answered what is none: a clause.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  std::optional<Answer<T>> answer_;
  std::string failure_;
};

/// Answers cases as the kernel under test does. Safe to share between threads.
class Subject {
 public:
  virtual ~Subject() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// One line: the formula and its source.
  [[nodiscard]] virtual std::string_view about() const = 0;
  /// What it does otherwise than the contract, by its own word.
  [[nodiscard]] virtual const Deviations& deviations() const = 0;
  [[nodiscard]] virtual Reply<float> answer(const Case<float>&) const = 0;
  [[nodiscard]] virtual Reply<double> answer(const Case<double>&) const = 0;
  /// The mode in which it is called.
  [[nodiscard]] virtual FloatMode float_mode() const { return FloatMode::nearest; }
  /// By its own word, all floating-point modes give the same answers.
  [[nodiscard]] virtual bool is_for_all_modes() const { return false; }
  /// What a command line wants beside its name to open it again, words for a shell.
  [[nodiscard]] virtual std::string_view options() const { return {}; }
  /// replies[i] for inputs[i], as if asked one by one; the spans are of one size.
  virtual void answer(std::span<const Case<float>> inputs, std::span<Reply<float>> replies) const;
  virtual void answer(std::span<const Case<double>> inputs, std::span<Reply<double>> replies) const;
};

/// All built-in subjects, graze first.
[[nodiscard]] std::span<const Subject* const> subjects();

/// The built-in subject of that name, or null.
[[nodiscard]] const Subject* find_subject(std::string_view name);

}  // namespace graze::fuzz
