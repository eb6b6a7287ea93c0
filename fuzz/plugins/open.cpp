#include "fuzz/plugins/open.hpp"

#include <algorithm>
#include <filesystem>

#include "fuzz/number_text.hpp"
#include "fuzz/plugins/process_subject.hpp"
#include "fuzz/shell_word.hpp"
#include "fuzz/words.hpp"

namespace graze::fuzz {
namespace {

using Opened = std::variant<std::unique_ptr<Subject>, std::string>;

constexpr std::string_view exec = "exec:";
constexpr std::string_view precision_word = "{precision}";
constexpr std::string_view mode_word = "{float-mode}";
constexpr double time_to_load = 60;  // seconds

std::string replaced(std::string text, std::string_view word, std::string_view by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// What was said on the command line, to be said again.
std::string told(const PluginOptions& options) {
  std::string text = options.declare.empty() ? "" : "--declare " + shell_word(options.declare);
  if (options.time_limit != default_time_limit) {
    text.append(text.empty() ? "" : " ").append("--time-limit " + format_number(options.time_limit, NumberForm::shortest));
  }
  return text;
}

/// The command for a shell, which makes way for it where it is one program with its arguments, so that the program's end is
/// seen as it is and the shell says nothing to it.
std::string for_shell(const std::string& command) {
  const bool is_plain = command.find_first_of(";&|<>()`$\n") == std::string::npos &&
                        command.substr(0, command.find(' ')).find('=') == std::string::npos;
  return is_plain ? "exec " + command : command;
}

/// Runs it on no case. A program that is not there or may not be run says so through the shell's exit status; what else it
/// does, the cases will tell.
std::string try_out(const std::vector<std::string>& command) {
  auto started = Process::start(command);
  if (const auto* error = std::get_if<std::string>(&started)) return *error;
  Process& process = *std::get<std::unique_ptr<Process>>(started);
  std::vector<std::string> lines;
  if (process.run({}, 1000, lines, Process::Seconds(5)) != Process::Outcome::ended) return {};
  (void)process.end();
  if (process.exit_status() == 127) return "is not found; check the path";
  if (process.exit_status() == 126) return "may not be run; allow it with chmod u+x";
  return {};
}

Opened open_program(const PluginOptions& options) {
  const std::string command = options.name.substr(exec.size());
  auto parsed = parse_declaration(options.declare);
  if (const auto* error = std::get_if<LineError>(&parsed)) return "--declare " + options.declare + ": " + error->what;
  auto& declaration = std::get<Declaration>(parsed);
  if (command.find_first_not_of(' ') == std::string::npos) return options.name + ": names no program; exec:./mine --flags does";
  if (options.mode != FloatMode::nearest && command.find(mode_word) == std::string::npos) {
    return options.name + ": a program sets its own floating-point mode: take " + std::string(mode_word) +
           " into the command, which is replaced by " + std::string(word_of(options.mode));
  }
  ProcessSubject::Settings settings{options.name, "the program " + command, declaration,  {},
                                    false,        options.time_limit,       options.mode, told(options)};
  if (command.find(precision_word) == std::string::npos && settings.declaration.offers[0] == settings.declaration.offers[1]) {
    settings.declaration.offers[0] = {};  // it can't know that float is wanted
  }
  for (const std::size_t p : {0, 1}) {
    const std::string in_mode = replaced(command, mode_word, word_of(options.mode));
    settings.commands[p] = {"/bin/sh", "-c", for_shell(replaced(in_mode, precision_word, p == 0 ? "float" : "double"))};
  }
  if (const std::string wrong = try_out(settings.commands[1]); !wrong.empty()) return options.name + ": the program " + wrong;
  return std::make_unique<ProcessSubject>(std::move(settings));
}

Opened open_library(const PluginOptions& options) {
  if (!options.declare.empty()) return options.name + ": a library declares for itself; --declare is for exec:COMMAND";
  std::error_code error;
  const auto kind = std::filesystem::status(options.name, error).type();
  if (kind == std::filesystem::file_type::not_found) return options.name + ": no such file";
  if (kind == std::filesystem::file_type::directory) return options.name + ": is a folder, not a shared library";
  const std::string path = std::filesystem::absolute(options.name).string();

  auto started = Process::start({options.worker, "subject-worker", "describe", path});
  if (const auto* wrong = std::get_if<std::string>(&started)) return options.name + ": the process that loads it " + *wrong;
  Process& process = *std::get<std::unique_ptr<Process>>(started);
  std::vector<std::string> lines;
  const auto outcome = process.ask({}, 3, lines, Process::Seconds(time_to_load));
  const auto field = [&](std::size_t i, std::string_view key) {
    return i < lines.size() && lines[i].starts_with(key) ? printable(std::string_view(lines[i]).substr(key.size()))
                                                         : std::string();
  };
  if (const std::string wrong = field(0, "error "); !wrong.empty()) return options.name + ": " + wrong;
  if (outcome == Process::Outcome::hung) return options.name + ": does not come back from loading";
  if (outcome != Process::Outcome::answered) return options.name + ": " + process.end() + " while it was loaded";
  auto parsed = parse_declaration(field(2, "declares "));
  if (const auto* wrong = std::get_if<LineError>(&parsed)) return options.name + ": " + wrong->what;
  ProcessSubject::Settings settings{
      options.name, field(0, "name "), std::get<Declaration>(parsed), {}, true, options.time_limit,
      options.mode, told(options)};
  if (const std::string about = field(1, "about "); !about.empty()) settings.about += ": " + about;
  for (const std::size_t p : {0, 1}) {
    settings.commands[p] = {options.worker, "subject-worker", p == 0 ? "float" : "double", std::string(word_of(options.mode)),
                            path};
  }
  return std::make_unique<ProcessSubject>(std::move(settings));
}

}  // namespace

bool is_plugin(std::string_view name) {
  return name.starts_with(exec) || name.find('/') != std::string_view::npos || name.ends_with(".so") ||
         name.ends_with(".dylib");
}

Opened open_plugin(const PluginOptions& options) {
  return options.name.starts_with(exec) ? open_program(options) : open_library(options);
}

}  // namespace graze::fuzz
