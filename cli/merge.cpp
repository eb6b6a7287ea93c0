#include "cli/merge.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/exit_status.hpp"
#include "cli/refuse.hpp"
#include "cli/report_file.hpp"
#include "fuzz/report/merge.hpp"
#include "fuzz/report/text.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  bool partial = false;
  Outputs outputs;
};

/// Which two files do not fit, and where. `reports` are those before the last file, which does not fit their sum.
std::string misfit(const std::vector<std::string>& files, const std::vector<fuzz::Report>& reports, const std::string& wrong) {
  for (std::size_t i = 0; i + 1 < reports.size(); ++i) {
    fuzz::Report one = reports[i];
    const std::string difference = merge(one, reports.back());
    if (!difference.empty()) return files[i] + " and " + files[reports.size() - 1] + " cannot be merged: " + difference;
  }
  return "the files before " + files[reports.size() - 1] + " and that one cannot be merged: " + wrong;
}

int run(const Options& options) {
  std::vector<fuzz::Report> reports;
  fuzz::Report sum;
  for (const std::string& file : options.files) {
    auto read = read_report(file);
    if (const auto* wrong = std::get_if<std::string>(&read)) return refuse_by_name(*wrong);
    reports.push_back(std::get<fuzz::Report>(std::move(read)));
    if (reports.size() == 1) sum = reports.front();
    if (const std::string wrong = merge(sum, reports.back()); !wrong.empty())
      return refuse_by_name(misfit(options.files, reports, wrong));
  }
  if (const std::string gap = missing(sum); !options.partial && !gap.empty()) {
    return refuse_by_name("missing: " + gap + "; --partial merges what there is");
  }
  print(sum, std::nullopt, std::cout);
  if (const std::string wrong = write_outputs(options.outputs, sum); !wrong.empty()) return refuse_by_name(wrong);
  return exit_status(sum);
}

}  // namespace

void add_merge(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("merge", "Make one report of those of shards or of broken-off runs");
  const auto options = std::make_shared<Options>();
  command->add_option("FILES", options->files, "reports that `graze certify --json` wrote, of one campaign, in any order")
      ->required();
  add_outputs(*command, options->outputs);
  command->add_flag("--partial", options->partial, "merge even where shards or cases are missing");
  command->footer(
      "The same cases in two files must have come out the same, and count once. Nothing missing, the report is byte for byte\n"
      "that of one run without shards.\nExit status: 0 nothing is wrong, 1 something is, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
