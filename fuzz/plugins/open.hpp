// A user's own kernel by what the command line calls it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// `exec:COMMAND`, or a path: something with a slash or that ends with .so or .dylib.
[[nodiscard]] bool is_plugin(std::string_view name);

inline constexpr double default_time_limit = 2;

struct PluginOptions {
  std::string name;     ///< exec:COMMAND or the path of a library
  std::string declare;  ///< of a program, as parse_declaration reads it; empty for a library, which declares for itself
  double time_limit = default_time_limit;  ///< seconds for an answer
  FloatMode mode = FloatMode::nearest;     ///< in which the kernel is called; a program must take it by {float-mode}
  std::string worker;                      ///< the program that runs `subject-worker`: graze
};

/// The subject, or a whole sentence about what is wrong.
[[nodiscard]] std::variant<std::unique_ptr<Subject>, std::string> open_plugin(const PluginOptions& options);

}  // namespace graze::fuzz
