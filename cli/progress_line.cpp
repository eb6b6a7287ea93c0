#include "cli/progress_line.hpp"

#include <unistd.h>

#include <chrono>
#include <iostream>

#include "fuzz/report/numbers.hpp"

namespace graze::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::string text_of_seconds(double seconds) {
  if (seconds < 100) return fuzz::formatted("%.0f s", seconds);
  if (seconds < 6000) return fuzz::formatted("%.0f min", seconds / 60);
  return fuzz::formatted("%.1f h", seconds / 3600);
}

std::string line(const fuzz::Progress& progress, std::string_view what, Clock::time_point start) {
  const std::uint64_t done = progress.cases_done, planned = progress.cases_planned, wrong = progress.discrepancies;
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const double rate = static_cast<double>(done) / seconds;
  std::string text = fuzz::grouped(done) + " of " + fuzz::grouped(planned) + " " + std::string(what);
  if (done != 0 && planned != 0) {
    text += fuzz::formatted(", %.0f %%, ", 100.0 * static_cast<double>(done) / static_cast<double>(planned)) +
            fuzz::grouped(static_cast<std::uint64_t>(rate)) + " a second, " +
            text_of_seconds(static_cast<double>(planned - done) / rate) + " left, " + fuzz::grouped(wrong) + " discrepancies";
  }
  return text;
}

}  // namespace

ProgressLine::ProgressLine(const fuzz::Progress& progress, std::string_view what) {
  if (isatty(STDERR_FILENO) == 0) return;
  thread_ = std::jthread([&progress, what](const std::stop_token& stop) {
    const Clock::time_point start = Clock::now();
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      std::cerr << "\r\033[K" << line(progress, what, start) << std::flush;
    }
    std::cerr << "\r\033[K" << std::flush;
  });
}

}  // namespace graze::cli
