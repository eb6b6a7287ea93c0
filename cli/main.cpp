// The program `graze`: one file a command.
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>

#include "cli/answer.hpp"
#include "cli/certify.hpp"
#include "cli/exit_status.hpp"
#include "cli/families.hpp"
#include "cli/merge.hpp"
#if defined(GRAZE_HAVE_PNG)
#include "cli/render.hpp"
#endif
#include "cli/shrink.hpp"
#include "cli/subject_worker.hpp"
#include "cli/trace.hpp"

namespace {

int run(int argc, char** argv) {
  int status = graze::cli::exit_well;
  CLI::App program("Ray intersection: every decision exact, every number correctly rounded.", "graze");
  program.set_version_flag("--version", "graze " GRAZE_VERSION);
  program.require_subcommand(0, 1);
  graze::cli::add_answer(program, status);
  graze::cli::add_certify(program, status);
  graze::cli::add_families(program, status);
  graze::cli::add_merge(program, status);
#if defined(GRAZE_HAVE_PNG)
  graze::cli::add_render(program, status);
#endif
  graze::cli::add_shrink(program, status);
  graze::cli::add_trace(program, status);
  graze::cli::add_inside(program, status);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version come this way too, with 0.
    return program.exit(error) == 0 ? graze::cli::exit_well : graze::cli::exit_bad_input;
  }
  if (program.get_subcommands().empty()) {
    std::cerr << "graze: a command is wanted\n" << program.help();
    return graze::cli::exit_bad_input;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto status = graze::cli::run_subject_worker({argv + 1, argv + argc})) return *status;
  std::ios::sync_with_stdio(false);
#ifdef SIGPIPE
  // A reader that goes away is a failed write, told by the exit status, not a signal.
  std::signal(SIGPIPE, SIG_IGN);
#endif
  int status = graze::cli::exit_bad_input;
  try {
    status = run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "graze: " << error.what() << '\n';
  }
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "graze: cannot write to standard output: it is closed, full or no longer read\n";
    status = graze::cli::exit_bad_input;
  }
  return status;
}
