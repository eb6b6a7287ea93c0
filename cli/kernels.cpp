#include "cli/kernels.hpp"

#include <CLI/CLI.hpp>

#include "fuzz/plugins/open.hpp"

namespace graze::cli {

CLI::Option* add_kernel_options(CLI::App& command, KernelOptions& options) {
  CLI::Option* kernel =
      command.add_option("--kernel", options.name,
                         "which kernel (default graze): " + kernel_names() +
                             "; or your own: a shared library, ./mine.so, or a program, 'exec:./mine --flags'");
  command.add_option("--declare", options.declare,
                     "what a program offers and how it deviates, comma-separated: ray_triangle,coplanar-is-miss,t-ulps=4");
  command.add_option("--time-limit", options.time_limit, "seconds in which a kernel of your own must answer (default 2)")
      ->check(CLI::PositiveNumber);
  return kernel;
}

Kernel open_kernel(const KernelOptions& options) {
  Kernel kernel;
  if (fuzz::is_plugin(options.name)) {
    auto opened = fuzz::open_plugin({options.name, options.declare, options.time_limit, "/proc/self/exe"});
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
  }
  return kernel;
}

}  // namespace graze::cli
