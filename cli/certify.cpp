#include "cli/certify.hpp"

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/campaign_options.hpp"
#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "cli/progress_line.hpp"
#include "cli/report_file.hpp"
#include "fuzz/report/merge.hpp"
#include "fuzz/report/numbers.hpp"
#include "fuzz/report/text.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::string kernel = "graze";
  CampaignOptions campaign;
  std::string shard;
  bool resume = false;
  Outputs outputs;
};

std::atomic<bool> interrupted{false};

/// The first signal asks for an end, the second makes one.
void interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

int refuse(const std::string& message) {
  std::cerr << "graze: " << message << '\n';
  return exit_bad_input;
}

/// Takes over what the file holds, if there is one.
std::string resume(const std::string& file, fuzz::Report& report) {
  if (!std::filesystem::exists(file)) return {};
  auto read = read_report(file);
  if (const auto* wrong = std::get_if<std::string>(&read)) return *wrong;
  const auto& before = std::get<fuzz::Report>(read);
  const std::set<fuzz::Shard> shards = report.shards;
  if (const std::string wrong = merge(report, before); !wrong.empty()) {
    return file + ": is of another campaign, so it cannot be resumed; now and in the file, " + wrong;
  }
  if (report.shards != shards && !report.is_whole()) return file + ": is of another shard, so it cannot be resumed";
  return {};
}

int run(const Options& options) {
  const fuzz::Subject* kernel = fuzz::find_subject(options.kernel);
  if (kernel == nullptr) return refuse("no kernel is named '" + options.kernel + "'; there are: " + kernel_names());
  const auto shard = options.shard.empty() ? fuzz::Shard() : fuzz::parse_shard(options.shard);
  if (!shard) return refuse("--shard " + options.shard + ": is no shard; 1/4 to 4/4 are the four of four");
  if (options.resume && options.outputs.json.empty())
    return refuse("--resume goes on from the file of --json, which is not given");
  fuzz::Campaign campaign;
  if (const std::string wrong = fill(campaign, options.campaign); !wrong.empty()) return refuse(wrong);

  const fuzz::Judges judges{*kernel, oracle::gmp_oracle(), oracle::cgal_oracle(), options.campaign.second_oracle_every};
  const fuzz::Plan plan(campaign);
  fuzz::Report report = fuzz::blank_report(campaign, plan, judges, *shard);
  if (options.resume) {
    if (const std::string wrong = resume(options.outputs.json, report); !wrong.empty()) return refuse(wrong);
  }
  if (const std::string wrong = write_outputs(options.outputs, report); !wrong.empty()) return refuse(wrong);

  fuzz::Progress progress;
  progress.stop = &interrupted;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  fuzz::Ledger ledger(report.rows);
  const auto start = std::chrono::steady_clock::now();
  {
    const ProgressLine line(progress);
    // A save that fails is told by the last one.
    const Saver saver([&options, &ledger, part = report]() mutable {
      part.rows = ledger.rows();
      (void)write_outputs({options.outputs.json}, part);
    });
    run(plan, judges, *shard, ledger, progress);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  report.rows = ledger.rows();
  print(report, seconds.count(), std::cout);
  if (const std::string wrong = write_outputs(options.outputs, report); !wrong.empty()) return refuse(wrong);
  return exit_status(report);
}

}  // namespace

void add_certify(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("certify", "Hold a kernel against the exact oracles on inputs that break kernels");
  const auto options = std::make_shared<Options>();
  command->add_option("--kernel", options->kernel, "which kernel (default graze): " + kernel_names());
  add_options(*command, options->campaign);
  command->add_option("--shard", options->shard, "only the i-th of N equal shares, for `graze merge`")->type_name("i/N");
  command->add_flag("--resume", options->resume, "go on from what the file of --json holds, if there is one");
  command->add_option("--json", options->outputs.json, "write the whole report here too, and what is done every 2 seconds")
      ->type_name("FILE");
  std::string families;
  for (const fuzz::Family& f : fuzz::families()) families += "  " + std::string(f.name) + ": " + std::string(f.attacks) + "\n";
  command->footer("Families:\n" + families + "Exit status: 0 nothing is wrong, 1 something is, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
