// The case protocol of the contract: one case a line, one answer a line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// What is wrong with a line: a clause in plain words, without file or line number, printable whatever the line holds.
struct LineError {
  std::string what;
};

/// Whether the protocol skips the line: it is blank, or its first character that is not a blank is `#`.
[[nodiscard]] bool is_skipped(std::string_view line);

/// Reads a case line. Words are parted by blanks (space, tab, carriage return, form feed, vertical tab), so the line may end
/// with CRLF. Numbers are what C's strtod takes, rounded to nearest in T alone, not by way of double: decimals, hexadecimal
/// floats, inf, nan; too large is infinity, too small 0 or subnormal. Wants the C locale and the default rounding mode, as
/// every program starts with.
template <Real T>
[[nodiscard]] std::variant<Case<T>, LineError> parse_case(std::string_view line);

/// What the numbers of a line are called: "a ray takes 6 numbers, ex ey ez dx dy dz, or 8 with t_min t_max".
struct NumbersText {
  std::string_view name;
  std::string_view numbers;  ///< their names, parted by blanks, without the range
  bool has_range;            ///< whether t_min t_max may follow, both or neither
};

/// Reads a line of numbers alone, as parse_case does, into `numbers`, the range's two included.
template <Real T>
[[nodiscard]] std::optional<LineError> parse_numbers(const NumbersText& text, std::string_view line,
                                                     std::span<T* const> numbers);

/// How numbers are written; both forms read back to the same bits.
enum class NumberForm {
  hexadecimal,  ///< 0x1.8p+1: the bits are seen
  shortest,     ///< the shortest decimal that reads back to the same number, as std::to_chars has it: 0.1, 1e+300
};

/// A number as the protocol writes it; `inf`, `-inf` and, for every NaN, `nan`.
template <Real T>
[[nodiscard]] std::string format_number(T number, NumberForm form);

/// The first word of the case line: ray_sphere, ray_triangle, point_line, point_plane, point_sphere.
template <Real T>
[[nodiscard]] std::string_view query_name(const Case<T>& input);

/// The case line, without its end. t_min and t_max are written where they are not 0 and infinity. Reads back to the same bits,
/// NaNs to some NaN.
template <Real T>
[[nodiscard]] std::string format_case(const Case<T>& input, NumberForm form = NumberForm::hexadecimal);

enum class Details : bool { no, yes };

/// The answer line, without its end: the kind and its values in shortest decimals. With details, `origin=` and, for a hit,
/// `root=`, or `facing=`; nothing more for a point or an invalid input. The case tells what a sign is called.
template <Real T>
[[nodiscard]] std::string format_answer(const Case<T>& input, const Answer<T>& answer, Details details = Details::no);

}  // namespace graze::fuzz
