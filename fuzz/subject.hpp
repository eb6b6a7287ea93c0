// A subject: a kernel under test, ours or another's, behind one interface.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// Answers cases as the kernel under test does; nullopt for a query that it does not offer. Stateless, safe to share between
/// threads.
class Subject {
 public:
  virtual ~Subject() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// One line: the formula and its source.
  [[nodiscard]] virtual std::string_view about() const = 0;
  [[nodiscard]] virtual std::optional<Answer<float>> answer(const Case<float>&) const = 0;
  [[nodiscard]] virtual std::optional<Answer<double>> answer(const Case<double>&) const = 0;
};

/// All built-in subjects, graze first.
[[nodiscard]] std::span<const Subject* const> subjects();

/// The built-in subject of that name, or null.
[[nodiscard]] const Subject* find_subject(std::string_view name);

}  // namespace graze::fuzz
