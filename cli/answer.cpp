#include "cli/answer.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "cli/line_source.hpp"
#include "cli/refuse.hpp"
#include "fuzz/case_text.hpp"
#include "fuzz/subject.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::string precision = "double";
  KernelOptions kernel;
  bool details = false;
  std::string file = "-";
};

template <Real T>
int answer_lines(const fuzz::Subject& kernel, fuzz::Details details, LineSource& lines) {
  while (true) {
    // Whoever writes the cases through a pipe and waits for the answers gets them.
    if (lines.would_wait()) std::cout.flush();
    // Further answers could not be written; the program's end tells why.
    if (!std::cout || !lines.next()) break;
    if (fuzz::is_skipped(lines.line())) continue;
    const auto parsed = fuzz::parse_case<T>(lines.line());
    if (const auto* error = std::get_if<fuzz::LineError>(&parsed)) return refuse(lines.place() + ": " + error->what);
    const auto& input = std::get<fuzz::Case<T>>(parsed);
    const auto answer = kernel.answer(input);
    if (!answer.failure().empty())
      return refuse(lines.place() + ": kernel " + std::string(kernel.name()) + " " + answer.failure());
    if (!answer) {
      return refuse(lines.place() + ": kernel " + std::string(kernel.name()) + " does not answer " +
                    std::string(fuzz::query_name(input)) + "; these do: " + kernel_names(&input));
    }
    std::cout << fuzz::format_answer(input, *answer, details) << '\n';
  }
  return lines.error().empty() ? exit_well : refuse(lines.error());
}

int run(const Options& options) {
  const Kernel kernel = open_kernel(options.kernel);
  if (!kernel.wrong.empty()) return refuse_by_name(kernel.wrong);
  LineSource lines(options.file);
  if (!lines.error().empty()) return refuse(lines.error());
  const auto details = fuzz::Details(options.details);
  return options.precision == "float" ? answer_lines<float>(*kernel.subject, details, lines)
                                      : answer_lines<double>(*kernel.subject, details, lines);
}

}  // namespace

void add_answer(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("answer", "Read one case a line, write one answer a line");
  const auto options = std::make_shared<Options>();
  command->add_option("--precision", options->precision, "double (default) or float")
      ->check(CLI::IsMember({"double", "float"}));
  add_kernel_options(*command, options->kernel);
  add_float_mode(*command, options->kernel.mode);
  command->add_flag("--details", options->details, "tell also origin= and root=, or facing=");
  command->add_option("file", options->file, "the cases; standard input where it is left out or -")->type_name("FILE");
  command->footer(
      "Cases:\n"
      "  ray_sphere   ex ey ez  dx dy dz  cx cy cz  r                    [t_min t_max]\n"
      "  ray_triangle ex ey ez  dx dy dz  ax ay az  bx by bz  cx cy cz   [t_min t_max]\n"
      "  point_line   px py  a b c\n"
      "  point_plane  px py pz  a b c d\n"
      "  point_sphere px py pz  cx cy cz  r");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
