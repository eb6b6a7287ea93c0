// Answer lines read back: what a program that speaks the case protocol says.
#pragma once

#include <string_view>
#include <variant>

#include "fuzz/case_text.hpp"

namespace graze::fuzz {

/// The line by which a program says that it does not offer the query.
inline constexpr std::string_view not_offered_line = "not_offered";

/// Reads what format_answer writes, with or without details. Values are where the contract has them, but u and v may be left
/// out, and `hit` may stand for the kind of a hit that is told apart from none: it is read as `face` or `secant`. A root that
/// is not told is `first` for a lone value, an origin `inside`, a facing `none`.
template <Real T>
[[nodiscard]] std::variant<Answer<T>, LineError> parse_answer(const Case<T>& input, std::string_view line);

}  // namespace graze::fuzz
