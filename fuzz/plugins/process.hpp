// A program at the other end of two pipes that answers lines with lines.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace graze::fuzz {

/// One thread at a time may use it. It runs in a process group of its own, so that an interrupt from the terminal is not its
/// end, and so that what it has started ends with it, and with this program (keeper.hpp). Wants SIGPIPE ignored.
class Process {
 public:
  using Seconds = std::chrono::duration<double>;

  /// Starts the command, its first word searched for in PATH; or what is wrong, a clause.
  [[nodiscard]] static std::variant<std::unique_ptr<Process>, std::string> start(const std::vector<std::string>& command);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  /// Ends its input, unless that is done gives it a second to end by itself, and kills it.
  ~Process();

  enum class Outcome {
    answered,
    ended,     ///< its output ended before
    hung,      ///< a line did not come in time
    too_long,  ///< a line is longer than `longest_line`
  };
  static constexpr std::size_t longest_line = 4096;

  /// Writes the text and appends `count` lines of its output, without their ends; blank lines and comments (#) are skipped.
  /// Each line must come within `limit` after the one before.
  [[nodiscard]] Outcome ask(std::string_view text, std::size_t count, std::vector<std::string>& lines, Seconds limit);

  /// Writes the text and ends its input, and appends all that it writes, up to `most` lines. `ended` if it ends its output,
  /// each line and the end within `limit` after the one before; `answered` where there are more lines.
  [[nodiscard]] Outcome run(std::string_view text, std::size_t most, std::vector<std::string>& lines, Seconds limit);

  /// How it ended, a clause; for after `ended`. Kills it where it has only closed its output.
  [[nodiscard]] std::string end();
  /// Kills it, and what it has started.
  void kill();
  /// Its exit status after `end`, as a shell tells it: 128 and the signal's number for a signal.
  [[nodiscard]] int exit_status() const { return exit_status_; }

 private:
  Process(pid_t pid, int in, int out) : pid_(pid), in_(in), out_(out) {}
  void close_input();
  /// Takes the next whole line off what was read; false where there is none.
  bool take_line(std::vector<std::string>& lines);
  /// Waits for output, or for input to be taken, and moves what there is; false at the deadline.
  bool exchange(std::string_view& text, std::chrono::steady_clock::time_point deadline);
  [[nodiscard]] bool is_line_too_long() const;

  pid_t pid_;
  int in_, out_;
  std::string read_;
  bool is_at_end_ = false;
  bool is_reaped_ = false;
  int exit_status_ = 0;
};

}  // namespace graze::fuzz
