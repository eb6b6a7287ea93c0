// The words of a line of the case protocol.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace graze::fuzz {

inline constexpr std::string_view blanks = " \t\r\f\v\n";

/// Takes the first word off the text; empty where none is left.
inline std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

/// The text of a stranger on one line: what does not print becomes \xHH, and what is longer than `longest` is cut.
[[nodiscard]] inline std::string printable(std::string_view text, std::size_t longest = 200) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string shown;
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      shown += c;
    } else {
      shown += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return text.size() > longest ? shown + "..." : shown;
}

/// The word in quotes for a message.
[[nodiscard]] inline std::string quoted(std::string_view word) {
  return "'" + printable(word, 40) + "'";
}

}  // namespace graze::fuzz
