#include "cli/shrink.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "cli/line_source.hpp"
#include "cli/positive.hpp"
#include "cli/refuse.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/shrink/failure.hpp"
#include "fuzz/shrink/shrink.hpp"
#include "fuzz/shrink/test_text.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::string precision = "double";
  KernelOptions kernel;
  std::uint64_t trials = fuzz::default_trials;
  bool test = false;
  std::string input = "-";
};

template <Real T>
void print(const fuzz::Subject& kernel, const fuzz::Failure& failure, const fuzz::Shrunk<T>& shrunk, const Options& options) {
  const fuzz::Case<T>& input = shrunk.input;
  const fuzz::Answer<T> truth = fuzz::answer_of(oracle::gmp_oracle(), input);
  const fuzz::FloatMode mode = kernel.float_mode();
  if (!shrunk.is_minimal) std::cerr << "graze: the trials ran out: a simpler case may fail too; raise --trials\n";
  const std::string title = std::string(fuzz::name_of(failure.disagreement)) + ": " + std::string(fuzz::query_name(input)) +
                            ", " + options.precision + ", " +
                            (mode == fuzz::FloatMode::nearest ? "" : std::string(fuzz::name_of(mode)) + ", ") + "where " +
                            std::string(kernel.name()) + " answers " + failure.answered;
  if (options.test) {
    std::cout << fuzz::catch_test(title, input, truth);
    return;
  }
  const fuzz::Reply<T> reply = kernel.answer(input);
  std::cout << "# " << title << '\n'
            << "# answers  " << (reply ? fuzz::format_answer(input, *reply, fuzz::Details::yes) : reply.failure()) << '\n'
            << "# exact    " << fuzz::format_answer(input, truth, fuzz::Details::yes) << '\n'
            << fuzz::format_case(input) << '\n';
}

/// What the line holds, shrunk; an ExitStatus. `place` is told with errors.
template <Real T>
int shrink_line(const fuzz::Subject& kernel, std::string_view line, const std::string& place, const Options& options) {
  const auto parsed = fuzz::parse_case<T>(line);
  if (const auto* error = std::get_if<fuzz::LineError>(&parsed)) return refuse(place + ": " + error->what);
  const auto& input = std::get<fuzz::Case<T>>(parsed);
  const fuzz::Failure failure = fuzz::failure_of(kernel, input);
  if (!failure.is_failure()) {
    std::cerr << place << ": kernel " << kernel.name() << " does not fail on this case in " << options.precision
              << ": there is nothing to shrink\n";
    return exit_well;
  }
  const fuzz::Fails<T> fails = [&](const fuzz::Case<T>& candidate) { return fuzz::failure_of(kernel, candidate) == failure; };
  print(kernel, failure, fuzz::shrink(input, fails, options.trials), options);
  return exit_found_wrong;
}

template <Real T>
int shrink_file(const fuzz::Subject& kernel, const Options& options) {
  LineSource lines(options.input);
  int status = exit_well;
  while (status != exit_bad_input && lines.next()) {
    if (fuzz::is_skipped(lines.line())) continue;
    status = std::max(status, shrink_line<T>(kernel, lines.line(), lines.place(), options));
  }
  return lines.error().empty() ? status : refuse(lines.error());
}

template <Real T>
int run(const fuzz::Subject& kernel, const Options& options) {
  // A case line has blanks, and a file of cases is seldom named so.
  const bool is_line = options.input.starts_with("ray_") || options.input.starts_with("point_");
  if (is_line && options.input.find(' ') != std::string::npos) {
    return shrink_line<T>(kernel, options.input, "graze", options);
  }
  return shrink_file<T>(kernel, options);
}

int run(const Options& options) {
  if (options.test && options.kernel.mode != fuzz::FloatMode::nearest) {
    return refuse_by_name(
        "--test writes tests that run in the default floating-point mode, so it goes with no other --float-mode");
  }
  const Kernel kernel = open_kernel(options.kernel);
  if (!kernel.wrong.empty()) return refuse_by_name(kernel.wrong);
  return options.precision == "float" ? run<float>(*kernel.subject, options) : run<double>(*kernel.subject, options);
}

}  // namespace

void add_shrink(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("shrink", "Find the simplest case on which a kernel fails in the same way");
  const auto options = std::make_shared<Options>();
  add_kernel_options(*command, options->kernel);
  add_float_mode(*command, options->kernel.mode);
  command->add_option("--precision", options->precision, "double (default) or float")
      ->check(CLI::IsMember({"double", "float"}));
  command->add_option("--trials", options->trials, "ask the kernel at most so often for a case (default 200000)")
      ->check(positive);
  command->add_flag("--test", options->test, "print a Catch2 test of graze instead of the case");
  command
      ->add_option("case", options->input, "a case line in quotes, or a file of them; standard input where it is left out or -")
      ->type_name("CASE|FILE");
  command->footer(
      "The same way: the same disagreement, kind answered, true kind, and class of a number's error. The result has its "
      "numbers in\n"
      "hexadecimal; it is minimal: none of them can be made zero, a smaller integer, shorter, positive or nearer to one.\n"
      "Exit status: 1 the kernel fails on a case, 0 on none, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
