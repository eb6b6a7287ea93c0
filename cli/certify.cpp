#include "cli/certify.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <variant>

#include "cli/campaign_options.hpp"
#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "cli/progress_line.hpp"
#include "cli/refuse.hpp"
#include "cli/report_file.hpp"
#include "fuzz/report/merge.hpp"
#include "fuzz/report/numbers.hpp"
#include "fuzz/report/page.hpp"
#include "fuzz/report/side_by_side.hpp"
#include "fuzz/report/text.hpp"

namespace graze::cli {
namespace {

struct Options {
  KernelOptions kernel;
  CampaignOptions campaign;
  std::vector<std::string> compared;
  std::vector<std::string> modes;
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

/// Judges what the report lacks. Told where it may be saved, it is, as it grows.
void judge(const fuzz::Plan& plan, const fuzz::Judges& judges, const fuzz::Shard& shard, fuzz::Report& report,
           const std::string& saved) {
  fuzz::Progress progress;
  progress.stop = &interrupted;
  fuzz::Ledger ledger(report.rows);
  {
    const ProgressLine line(progress);
    // A save that fails is told by the last one.
    const Saver saver([&saved, &ledger, part = report]() mutable {
      part.rows = ledger.rows();
      (void)write_outputs({saved}, part);
    });
    run(plan, judges, shard, ledger, progress);
  }
  report.rows = ledger.rows();
}

/// Which kernels are judged, on what, and how.
struct Setting {
  std::vector<Kernel> opened;                                   ///< owns what `kernels` names
  std::vector<std::vector<const fuzz::Subject*>> kernels = {};  ///< each in its floating-point modes
  fuzz::Campaign campaign;
  std::uint64_t second_oracle_every = 0;

  [[nodiscard]] fuzz::Judges judges(std::size_t kernel) const {
    return {kernels[kernel], oracle::gmp_oracle(), oracle::cgal_oracle(), second_oracle_every};
  }
};

/// The modes that the words of --float-mode name, each once; or what is wrong.
std::variant<std::vector<fuzz::FloatMode>, std::string> parse_modes(const std::vector<std::string>& words) {
  std::vector<fuzz::FloatMode> modes;
  for (const std::string& word : words) {
    if (word != "all" && !fuzz::find_float_mode(word)) {
      return "--float-mode " + word + ": there are " + float_mode_words() + ", all";
    }
  }
  for (const fuzz::FloatMode mode : fuzz::float_modes) {
    const auto names = [mode](const std::string& word) { return word == "all" || word == fuzz::word_of(mode); };
    if (std::any_of(words.begin(), words.end(), names)) modes.push_back(mode);
  }
  return modes;
}

/// Opens a kernel in each of the modes, where none is named in those for which it is made; what is wrong, if anything.
std::string open(const KernelOptions& options, std::vector<fuzz::FloatMode> modes, bool is_compared, Setting& setting) {
  if (modes.empty()) {
    const fuzz::Subject* built_in = fuzz::find_subject(options.name);
    const bool takes_all = built_in != nullptr && built_in->is_for_all_modes() && !is_compared;
    const auto known = std::span(fuzz::float_modes).first(takes_all ? fuzz::float_modes.size() : 1);
    modes.assign(known.begin(), known.end());
  }
  setting.kernels.emplace_back();
  for (const fuzz::FloatMode mode : modes) {
    KernelOptions in_mode = options;
    in_mode.mode = mode;
    setting.opened.push_back(open_kernel(in_mode));
    if (!setting.opened.back().wrong.empty()) return setting.opened.back().wrong;
    setting.kernels.back().push_back(setting.opened.back().subject);
  }
  return {};
}

/// One kernel, in whole or in part.
int certify(const Setting& setting, const fuzz::Plan& plan, const Options& options, const fuzz::Shard& shard) {
  const auto start = std::chrono::steady_clock::now();
  const fuzz::Judges judges = setting.judges(0);
  fuzz::Report report = fuzz::blank_report(setting.campaign, plan, judges, shard);
  if (options.resume) {
    if (const std::string wrong = resume(options.outputs.json, report); !wrong.empty()) return refuse_by_name(wrong);
  }
  if (const std::string wrong = write_outputs(options.outputs, report); !wrong.empty()) return refuse_by_name(wrong);
  judge(plan, judges, shard, report, options.outputs.json);
  print(report, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), std::cout);
  if (const std::string wrong = write_outputs(options.outputs, report); !wrong.empty()) return refuse_by_name(wrong);
  return exit_status(report);
}

/// Several kernels side by side: 1 where any is wrong.
int compare(const Setting& setting, const fuzz::Plan& plan, const std::string& html) {
  std::vector<fuzz::Report> reports;
  int status = exit_well;
  const auto write = [&] { return html.empty() ? std::string() : write_file(html, fuzz::comparison_page(reports)); };
  for (std::size_t i = 0; i < setting.kernels.size(); ++i) {
    reports.push_back(fuzz::blank_report(setting.campaign, plan, setting.judges(i), {}));
  }
  if (const std::string wrong = write(); !wrong.empty()) return refuse_by_name(wrong);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    judge(plan, setting.judges(i), {}, reports[i], {});
    // Wrong outweighs interrupted.
    const int one = exit_status(reports[i]);
    if (status != exit_found_wrong && one != exit_well) status = one;
  }
  print_side_by_side(reports, std::cout);
  if (const std::string wrong = write(); !wrong.empty()) return refuse_by_name(wrong);
  return status;
}

int run(const Options& options) {
  Setting setting;
  setting.second_oracle_every = options.campaign.second_oracle_every;
  std::vector<std::string> names = options.compared;
  if (names == std::vector<std::string>{"all"}) {
    names.clear();
    for (const fuzz::Subject* kernel : fuzz::subjects()) names.emplace_back(kernel->name());
  }
  if (names.empty()) names.push_back(options.kernel.name);
  const auto modes = parse_modes(options.modes);
  if (const auto* wrong = std::get_if<std::string>(&modes)) return refuse_by_name(*wrong);
  for (const std::string& name : names) {
    KernelOptions one = options.kernel;
    one.name = name;
    const std::string wrong = open(one, std::get<std::vector<fuzz::FloatMode>>(modes), !options.compared.empty(), setting);
    if (!wrong.empty()) return refuse_by_name(wrong);
  }
  const auto shard = options.shard.empty() ? fuzz::Shard() : fuzz::parse_shard(options.shard);
  if (!shard) return refuse_by_name("--shard " + options.shard + ": is no shard; 1/4 to 4/4 are the four of four");
  if (options.resume && options.outputs.json.empty())
    return refuse_by_name("--resume goes on from the file of --json, which is not given");
  if (const std::string wrong = fill(setting.campaign, options.campaign); !wrong.empty()) return refuse_by_name(wrong);
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  const fuzz::Plan plan(setting.campaign);
  return options.compared.empty() ? certify(setting, plan, options, *shard) : compare(setting, plan, options.outputs.html);
}

}  // namespace

void add_certify(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("certify", "Hold a kernel against the exact oracles on inputs that break kernels");
  const auto options = std::make_shared<Options>();
  CLI::Option* kernel = add_kernel_options(*command, options->kernel);
  add_options(*command, options->campaign);
  command
      ->add_option("--float-mode", options->modes,
                   "the floating-point modes in which the kernel is called, comma-separated: " + float_mode_words() +
                       ", all (default all for graze, which promises them, and nearest for others and --compare)")
      ->delimiter(',');
  CLI::Option* compare = command->add_option("--compare", options->compared,
                                             "several kernels side by side, your own too; `all` for all that are built in");
  const auto alone = [compare](CLI::Option* option) { option->excludes(compare); };
  alone(kernel);
  alone(command->add_option("--shard", options->shard, "only the i-th of N equal shares, for `graze merge`")->type_name("i/N"));
  alone(command->add_flag("--resume", options->resume, "go on from what the file of --json holds, if there is one"));
  add_outputs(*command, options->outputs, compare);
  std::string families;
  for (const fuzz::Family& f : fuzz::families()) families += "  " + std::string(f.name) + ": " + std::string(f.attacks) + "\n";
  command->footer("Families:\n" + families + "Exit status: 0 nothing is wrong, 1 something is, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
