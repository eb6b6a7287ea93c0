// Reports on disk.
#pragma once

#include <CLI/CLI.hpp>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <variant>

#include "fuzz/report/report.hpp"

namespace graze::cli {

/// Writes the whole file or leaves it as it was: a neighbour, FILE.part, is written and renamed. A device or a pipe is written
/// into. Returns what is wrong, a sentence with its cure, or nothing.
[[nodiscard]] std::string write_file(const std::string& file, std::string_view text);

/// A report, or what is wrong, a sentence that names the file.
[[nodiscard]] std::variant<fuzz::Report, std::string> read_report(const std::string& file);

/// As `--json` writes it.
[[nodiscard]] std::string json_text(const fuzz::Report& report);

/// Where a command writes its report besides standard output; empty: nowhere.
struct Outputs {
  std::string json, html, junit;
};
/// `not_with`, where given, excludes what makes no sense beside it.
void add_outputs(CLI::App& command, Outputs& outputs, CLI::Option* not_with = nullptr);
[[nodiscard]] std::string write_outputs(const Outputs& outputs, const fuzz::Report& report);

/// Calls `save` at intervals, from a thread of its own, while it lives.
class Saver {
 public:
  explicit Saver(std::function<void()> save);

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

/// 0, 1 or 2, by the verdict.
[[nodiscard]] int exit_status(const fuzz::Report& report);

}  // namespace graze::cli
