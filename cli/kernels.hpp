// The kernels that a command can name: built in, or the user's own.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "fuzz/plugins/open.hpp"
#include "fuzz/subject.hpp"

namespace graze::cli {

/// The names of the built-in kernels that answer this case, or of all for none; comma-separated.
template <Real T = double>
[[nodiscard]] std::string kernel_names(const fuzz::Case<T>* input = nullptr) {
  std::string names;
  for (const fuzz::Subject* kernel : fuzz::subjects()) {
    if (input != nullptr && !kernel->answer(*input)) continue;
    names.append(names.empty() ? "" : ", ").append(kernel->name());
  }
  return names;
}

struct KernelOptions {
  std::string name = "graze";  ///< built in, a shared library, or exec:COMMAND
  std::string declare;
  double time_limit = fuzz::default_time_limit;
  fuzz::FloatMode mode = fuzz::FloatMode::nearest;  ///< in which it is called
};

/// Adds --kernel, --declare and --time-limit to the command, and tells the first.
CLI::Option* add_kernel_options(CLI::App& command, KernelOptions& options);
/// Adds --float-mode with one mode.
void add_float_mode(CLI::App& command, fuzz::FloatMode& mode);
/// The words that --float-mode takes, comma-separated.
[[nodiscard]] std::string float_mode_words();

struct Kernel {
  const fuzz::Subject* subject = nullptr;
  std::unique_ptr<fuzz::Subject> own;  ///< behind `subject` where it is not one that is built in, as it is
  std::string wrong;                   ///< a whole sentence where there is no subject
};
[[nodiscard]] Kernel open_kernel(const KernelOptions& options);

}  // namespace graze::cli
