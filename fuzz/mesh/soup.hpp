// What the readers of mesh formats share: points and polygons as they are read, the words of a text, the bytes of a file.
//
// Not CGAL's readers: those of 5.5.1 allocate by the counts that a file claims, take a NaN in an STL file for another corner,
// say nothing of the place of an error, and are not compiled by clang 19.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/mesh/mesh.hpp"
#include "fuzz/number_text.hpp"

namespace graze::fuzz {

/// A mesh while it is read. Indices are checked when all points are known.
struct Soup {
  std::vector<Vec3<double>> points;
  std::vector<std::vector<std::int64_t>> polygons;
};

/// The formats; each throws MeshError, with the place in the file but without the file's name.
void parse_off(std::string_view bytes, Soup& soup);
void parse_obj(std::string_view bytes, Soup& soup);
void parse_ply(std::string_view bytes, Soup& soup);
void parse_stl(std::string_view bytes, Soup& soup);

/// The words of a text, with their lines. What follows the comment character in a line is left out.
class Words {
 public:
  static constexpr char no_comment = '\0';
  explicit Words(std::string_view text, char comment = no_comment) : text_(text), comment_(comment) {}

  /// Moves to the next line that has a word; false at the end.
  bool next_line() {
    while (!text_.empty()) {
      const std::size_t end = text_.find('\n');
      line_ = text_.substr(0, end);
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      ++number_;
      if (comment_ != no_comment) line_ = line_.substr(0, line_.find(comment_));
      skip_blanks();
      if (!line_.empty()) return true;
    }
    return false;
  }

  /// Takes the next word of this line; empty at its end.
  std::string_view word() {
    const std::string_view word = line_.substr(0, line_.find_first_of(blanks));
    line_.remove_prefix(word.size());
    skip_blanks();
    return word;
  }
  /// The next word of this line or of the next; an error at the end of the text.
  std::string_view any_word() {
    if (line_.empty() && !next_line()) fail("the file ends too early");
    return word();
  }
  [[nodiscard]] std::string_view rest_of_text() const { return text_; }

  /// The word as a finite number, a coordinate.
  double coordinate(std::string_view word) const {
    const auto x = parse_number<double>(word);
    if (!x) fail("a number is wanted where '" + printable(word) + "' stands");
    if (!std::isfinite(*x)) fail("a coordinate that is not finite");
    return *x;
  }
  /// The word as an integer.
  std::int64_t integer(std::string_view word) const {
    const auto x = parse_number<double>(word);
    if (!x || *x != std::trunc(*x) || std::abs(*x) > 0x1p53) {
      fail("an integer is wanted where '" + printable(word) + "' stands");
    }
    return static_cast<std::int64_t>(*x);
  }
  std::int64_t count(std::string_view word) const {
    const std::int64_t n = integer(word);
    if (n < 0) fail("a count below zero");
    return n;
  }

  /// Every error of a text is told with its line.
  [[noreturn]] void fail(const std::string& what) const { throw MeshError{std::to_string(number_) + ": " + what}; }

 private:
  static constexpr std::string_view blanks = " \t\r\f\v";

  static std::string printable(std::string_view word) {
    std::string text(word.substr(0, 40));
    for (char& c : text) c = c > ' ' && c <= '~' ? c : '?';
    return word.size() > 40 ? text + "..." : text;
  }
  void skip_blanks() { line_.remove_prefix(std::min(line_.find_first_not_of(blanks), line_.size())); }

  std::string_view text_, line_;
  char comment_;
  std::size_t number_ = 0;
};

/// The bytes of a binary file, read in order.
class Bytes {
 public:
  Bytes(std::string_view bytes, std::endian order) : bytes_(bytes), order_(order) {}

  /// False where so many are not left.
  template <class Number>
  bool read(Number& number) {
    if (bytes_.size() < sizeof(Number)) return false;
    char raw[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      raw[order_ == std::endian::native ? i : sizeof(Number) - 1 - i] = bytes_[i];
    }
    std::memcpy(&number, raw, sizeof(Number));
    bytes_.remove_prefix(sizeof(Number));
    return true;
  }

 private:
  std::string_view bytes_;
  std::endian order_;
};

}  // namespace graze::fuzz
