#include "cli/certify.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/certify_report.hpp"
#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "fuzz/certify/campaign.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::string kernel = "graze";
  std::uint64_t cases = 10000;
  std::uint64_t seed = 1;
  std::uint64_t second_oracle_every = 16;
  std::vector<std::string> families, meshes;
  std::string json;
};

std::atomic<bool> interrupted{false};

void interrupt(int) {
  interrupted = true;
}

/// A line on a terminal, kept up to date while the campaign runs.
class ProgressLine {
 public:
  explicit ProgressLine(const fuzz::Progress& progress) {
    if (isatty(STDERR_FILENO) == 0) return;
    thread_ = std::jthread([&progress](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        const std::uint64_t done = progress.cases_done, planned = std::max<std::uint64_t>(progress.cases_planned, 1);
        std::cerr << "\r\033[K" << done << " of " << planned << " cases, " << 100 * done / planned << " %" << std::flush;
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
      }
      std::cerr << "\r\033[K" << std::flush;
    });
  }

 private:
  std::jthread thread_;
};

int refuse(const std::string& message) {
  std::cerr << "graze: " << message << '\n';
  return exit_bad_input;
}

/// Fills the campaign; what is wrong with the options otherwise.
std::string plan(const Options& options, fuzz::Campaign& campaign) {
  campaign.seed = options.seed;
  campaign.cases = options.cases;
  for (const fuzz::Family& family : fuzz::families()) {
    if (options.families.empty()) campaign.families.push_back(&family);
  }
  for (const std::string& name : options.families) {
    const fuzz::Family* family = fuzz::find_family(name);
    if (family == nullptr) {
      std::string names;
      for (const fuzz::Family& f : fuzz::families()) names.append(names.empty() ? "" : ", ").append(f.name);
      return "no family is named '" + name + "'; there are: " + names;
    }
    campaign.families.push_back(family);
  }
  for (const std::string& file : options.meshes) {
    auto mesh = fuzz::read_mesh(file);
    if (const auto* error = std::get_if<fuzz::MeshError>(&mesh)) return error->what;
    campaign.meshes.push_back(std::get<fuzz::Mesh>(std::move(mesh)));
    const auto open = fuzz::open_edges(campaign.meshes.back());
    if (!open.empty()) {
      return file + ": is not closed: the edge from point " + std::to_string(open.front().from) + " to point " +
             std::to_string(open.front().to) + " has no reverse (" + std::to_string(open.size()) + " such edges)";
    }
  }
  // Families chosen by name alone run alone.
  if (options.meshes.empty() && options.families.empty()) campaign.meshes = {fuzz::icosphere(4), fuzz::wavy_sphere(4)};
  return {};
}

int run(const Options& options) {
  const fuzz::Subject* kernel = fuzz::find_subject(options.kernel);
  if (kernel == nullptr) return refuse("no kernel is named '" + options.kernel + "'; there are: " + kernel_names());
  fuzz::Campaign campaign;
  if (const std::string wrong = plan(options, campaign); !wrong.empty()) return refuse(wrong);
  std::ofstream json;
  if (!options.json.empty()) {
    json.open(options.json);
    if (!json) return refuse(options.json + ": cannot be written; check the folder and its permissions");
  }

  fuzz::Progress progress;
  progress.stop = &interrupted;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  const fuzz::Judges judges{*kernel, oracle::gmp_oracle(), oracle::cgal_oracle(), options.second_oracle_every};
  CertifyReport report{std::string(kernel->name()),
                       std::string(kernel->about()),
                       kernel->deviations(),
                       options.seed,
                       options.cases,
                       options.second_oracle_every,
                       false,
                       0,
                       {}};
  const auto start = std::chrono::steady_clock::now();
  {
    const ProgressLine line(progress);
    report.rows = fuzz::run(campaign, judges, progress);
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.is_interrupted = interrupted;

  print(report, std::cout);
  if (json.is_open() && !(json << to_json(report).dump(2) << '\n' << std::flush)) {
    return refuse(options.json + ": could not be written to its end; is the disk full?");
  }
  const bool is_wrong = !report.total().is_clean() || report.lost_rays() != 0;
  return is_wrong ? exit_found_wrong : report.is_complete() ? exit_well : exit_bad_input;
}

}  // namespace

void add_certify(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("certify", "Hold a kernel against the exact oracles on inputs that break kernels");
  const auto options = std::make_shared<Options>();
  command->add_option("--kernel", options->kernel, "which kernel (default graze): " + kernel_names());
  command->add_option("--cases", options->cases, "cases a family and precision (default 10000)")->check(CLI::PositiveNumber);
  command->add_option("--seed", options->seed, "of the families' streams (default 1)");
  command->add_option("--families", options->families, "only these, comma-separated (default all)")->delimiter(',');
  command->add_option("--mesh", options->meshes,
                      "closed meshes to aim at from inside (default: two generated ones, unless families are named)");
  command->add_option("--json", options->json, "write the whole report here too")->type_name("FILE");
  command->add_option("--second-oracle-every", options->second_oracle_every,
                      "CGAL confirms every N-th case (default 16, 1 for all, 0 for none)");
  std::string families;
  for (const fuzz::Family& f : fuzz::families()) families += "  " + std::string(f.name) + ": " + std::string(f.attacks) + "\n";
  command->footer("Families:\n" + families + "Exit status: 0 nothing is wrong, 1 something is, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
