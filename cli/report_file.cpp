#include "cli/report_file.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "cli/exit_status.hpp"
#include "fuzz/report/json.hpp"
#include "fuzz/report/junit.hpp"
#include "fuzz/report/page.hpp"

namespace graze::cli {
namespace {

constexpr std::chrono::seconds save_interval{2};

}  // namespace

std::string write_file(const std::string& file, std::string_view text) {
  std::error_code ignored;
  const auto kind = std::filesystem::status(file, ignored).type();
  if (kind == std::filesystem::file_type::directory) return file + ": is a folder; name a file in it";
  const bool is_plain = kind == std::filesystem::file_type::regular || kind == std::filesystem::file_type::not_found;
  const std::string part = is_plain ? file + ".part" : file;
  std::ofstream out(part, std::ios::binary);
  if (!out) return file + ": cannot be written; check the folder and its permissions";
  if (!(out << text << std::flush)) return file + ": could not be written to its end; is the disk full?";
  out.close();
  if (is_plain && std::rename(part.c_str(), file.c_str()) != 0) {
    return file + ": cannot be put in the place of what is there: " + std::strerror(errno);
  }
  return {};
}

std::variant<fuzz::Report, std::string> read_report(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return file + ": is a folder; name a report in it";
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) return file + ": cannot be read: " + std::strerror(errno) + "; check the path";
  auto report = fuzz::parse_report(text.str());
  if (const auto* error = std::get_if<fuzz::ReportError>(&report)) return file + ": " + error->what;
  return std::get<fuzz::Report>(std::move(report));
}

std::string json_text(const fuzz::Report& report) {
  return fuzz::to_json(report).dump(2, ' ', false, fuzz::Json::error_handler_t::replace) + '\n';
}

void add_outputs(CLI::App& command, Outputs& outputs, CLI::Option* not_with) {
  CLI::Option* json =
      command.add_option("-o,--json", outputs.json, "write the whole report here too, for `graze merge` and other programs");
  CLI::Option* html = command.add_option("--html", outputs.html, "write it as a page here");
  CLI::Option* junit = command.add_option("--junit", outputs.junit, "write it as JUnit XML here, a test case a row");
  for (CLI::Option* option : {json, html, junit}) option->type_name("FILE");
  if (not_with == nullptr) return;
  json->excludes(not_with);
  junit->excludes(not_with);
}

std::string write_outputs(const Outputs& outputs, const fuzz::Report& report) {
  std::string wrong;
  if (!outputs.json.empty()) wrong = write_file(outputs.json, json_text(report));
  if (wrong.empty() && !outputs.html.empty()) wrong = write_file(outputs.html, fuzz::page(report));
  if (wrong.empty() && !outputs.junit.empty()) wrong = write_file(outputs.junit, fuzz::junit(report));
  return wrong;
}

Saver::Saver(std::function<void()> save) {
  thread_ = std::jthread([this, save = std::move(save)](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, stop, save_interval, [&] { return stop.stop_requested(); })) save();
  });
}

int exit_status(const fuzz::Report& report) {
  const fuzz::Verdict verdict = report.verdict();
  return verdict == fuzz::Verdict::pass ? exit_well : verdict == fuzz::Verdict::fail ? exit_found_wrong : exit_bad_input;
}

}  // namespace graze::cli
