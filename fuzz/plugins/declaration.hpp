// What a kernel of a user's declares, as a list of words: which queries and precisions it offers, and how it deviates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "fuzz/case.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/deviations.hpp"

namespace graze::fuzz {

struct Declaration {
  /// By precision (0 float, 1 double) and query, in the order of Case.
  std::array<std::array<bool, 5>, 2> offers{};
  Deviations deviations;

  template <Real T>
  [[nodiscard]] bool offers_query(const Case<T>& input) const {
    return offers[sizeof(T) == sizeof(double)][input.index()];
  }
};

/// Reads words parted by commas: names of queries (only these are offered; all where none is named), `float` or `double` (only
/// that precision; both where neither is named), names of deviations, `t-ulps=K` and `uv-ulps=K`.
[[nodiscard]] std::variant<Declaration, LineError> parse_declaration(std::string_view words);

}  // namespace graze::fuzz
