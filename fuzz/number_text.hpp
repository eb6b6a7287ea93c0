// A number from a word of text.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "graze/types.hpp"

namespace graze::fuzz {

/// What C's strtod makes of the whole word, rounded to nearest in T alone, not by way of double; nothing where it is no number.
/// Too large is infinity, too small 0 or subnormal. Wants the C locale and the default rounding mode, as every program starts
/// with.
template <Real T>
[[nodiscard]] inline std::optional<T> parse_number(std::string_view word) {
  const std::string terminated(word);
  char* end = nullptr;
  T number{};
  if constexpr (std::same_as<T, float>) {
    number = std::strtof(terminated.c_str(), &end);
  } else {
    number = std::strtod(terminated.c_str(), &end);
  }
  // An empty word is no number; a NUL inside ends the number early, so it is caught here too.
  if (word.empty() || end != terminated.c_str() + terminated.size()) return std::nullopt;
  return number;
}

}  // namespace graze::fuzz
