// The lines of a file or of standard input, in bounded memory.
#pragma once

#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace graze::cli {

/// Reads line by line. What goes wrong ends the lines and is told by `error`.
class LineSource {
 public:
  /// Lines longer than this are an error, so that no input can fill the memory.
  static constexpr std::size_t longest_line = std::size_t{1} << 20;

  /// Opens the file, or standard input for "-".
  explicit LineSource(const std::string& path);

  /// Moves to the next line; false at the end and after an error. The last line needs no newline; NULs are kept.
  bool next();

  /// Without its newline; a carriage return is kept. Valid until `next`.
  [[nodiscard]] std::string_view line() const { return line_; }

  /// Whether `next` would have to wait, or to ask the system, for input: the moment to flush what was answered so far.
  [[nodiscard]] bool would_wait() { return input_->rdbuf()->in_avail() <= 0; }

  /// "FILE:LINE" of the current line; standard input is named <stdin>.
  [[nodiscard]] std::string place() const;

  /// Empty while all is well, else a whole message with what to do about it.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::ifstream file_;
  std::istream* input_;
  std::string name_;
  std::vector<char> buffer_;
  std::string_view line_;
  unsigned long long number_ = 0;
  std::string error_;
};

}  // namespace graze::cli
