#include "cli/kernels.hpp"

#include <CLI/CLI.hpp>

#include "cli/positive.hpp"
#include "fuzz/in_float_mode.hpp"

namespace graze::cli {

CLI::Option* add_kernel_options(CLI::App& command, KernelOptions& options) {
  CLI::Option* kernel =
      command.add_option("--kernel", options.name,
                         "which kernel (default graze): " + kernel_names() +
                             "; or your own: a shared library, ./mine.so, or a program, 'exec:./mine --flags'");
  command.add_option("--declare", options.declare,
                     "what a program offers and how it deviates, comma-separated: ray_triangle,coplanar-is-miss,t-ulps=4");
  command.add_option("--time-limit", options.time_limit, "seconds in which a kernel of your own must answer (default 2)")
      ->check(positive);
  return kernel;
}

std::string float_mode_words() {
  std::string words;
  for (const fuzz::FloatMode mode : fuzz::float_modes) words.append(words.empty() ? "" : ", ").append(fuzz::word_of(mode));
  return words;
}

void add_float_mode(CLI::App& command, fuzz::FloatMode& mode) {
  command.add_option_function<std::string>(
      "--float-mode",
      [&mode](const std::string& word) {
        const auto found = fuzz::find_float_mode(word);
        if (!found) throw CLI::ValidationError("--float-mode", "'" + word + "' is none of " + float_mode_words());
        mode = *found;
      },
      "the floating-point mode in which the kernel is called (default nearest): " + float_mode_words());
}

Kernel open_kernel(const KernelOptions& options) {
  Kernel kernel;
  if (fuzz::is_plugin(options.name)) {
    auto opened = fuzz::open_plugin({options.name, options.declare, options.time_limit, options.mode, "/proc/self/exe"});
    if (auto* wrong = std::get_if<std::string>(&opened)) {
      kernel.wrong = std::move(*wrong);
    } else {
      kernel.own = std::get<std::unique_ptr<fuzz::Subject>>(std::move(opened));
      kernel.subject = kernel.own.get();
    }
    return kernel;
  }
  kernel.subject = fuzz::find_subject(options.name);
  if (kernel.subject == nullptr) {
    kernel.wrong = "no kernel is named '" + options.name + "'; there are: " + kernel_names() +
                   ", and your own: ./mine.so or 'exec:./mine --flags'";
  } else if (!options.declare.empty()) {
    kernel.wrong = "--declare is for a program of your own, --kernel exec:COMMAND; " + options.name + " is built in";
  } else if (options.mode != fuzz::FloatMode::nearest) {
    kernel.own = std::make_unique<fuzz::InFloatMode>(*kernel.subject, options.mode);
    kernel.subject = kernel.own.get();
  }
  return kernel;
}

}  // namespace graze::cli
