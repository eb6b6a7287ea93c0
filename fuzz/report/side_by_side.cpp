#include "fuzz/report/side_by_side.hpp"

#include <algorithm>

#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

std::string padded(const std::string& text, std::size_t width) {
  return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

void print_kernels(std::span<const Report> reports, std::ostream& out) {
  out << formatted("%-20s %-10s %12s %22s %10s %10s %12s %10s %18s\n", "kernel", "verdict", "answers", "wrong kinds",
                   "lost hits", "false hits", "too far off", "worst ulp", "lost rays");
  for (const Report& report : reports) {
    const Part total = report.total();
    const Tally& t = total.tally;
    const std::string rays = total.rays == 0 ? "-" : grouped(total.lost_rays) + " of " + grouped(total.rays);
    out << formatted("%-20s %-10s %12s %22s %10s %10s %12s %10s %18s\n", report.scope.kernel.c_str(),
                     std::string(name_of(report.verdict())).c_str(), grouped(t.answers).c_str(),
                     (grouped(t.wrong_kinds()) + " (" + percent(t.wrong_kinds(), t.answers) + ")").c_str(),
                     grouped(t.count(Disagreement::lost_hit)).c_str(), grouped(t.count(Disagreement::false_hit)).c_str(),
                     grouped(t.count(Disagreement::misrounded)).c_str(), worst_error(t).c_str(), rays.c_str());
  }
}

}  // namespace

std::string short_error(const Tally& tally) {
  return tally.misrounded == 0 ? "<= 0.5" : formatted("%.2g", tally.worst_ulps);
}

std::string percent(std::uint64_t n, std::uint64_t of) {
  if (n == 0) return "0 %";
  if (n == of) return "100 %";
  const double share = 100.0 * static_cast<double>(n) / static_cast<double>(of);
  if (share < 0.1) return formatted("%.1g %%", share);
  return formatted("%.1f %%", std::min(share, 99.9));
}

void print_side_by_side(std::span<const Report> reports, std::ostream& out) {
  print_kernels(reports, out);
  out << "\nWrong decisions and the worst error in ulps:\n\n" << formatted("%-34s %-9s", "family", "precision");
  for (const Report& report : reports) out << ' ' << padded(report.scope.kernel, 17);
  out << '\n';
  for (std::size_t i = 0; i < reports.front().rows.size(); ++i) {
    const Row& row = reports.front().rows[i];
    out << formatted("%-34s %-9s", row.name.c_str(), row.precision.c_str());
    for (const Report& report : reports) {
      const Tally t = report.rows[i].total().tally;
      const std::uint64_t wrong = t.wrong_kinds() + t.count(Disagreement::failed);
      const std::string cell = t.answers == 0 ? "-" : percent(wrong, t.answers) + ", " + short_error(t);
      out << ' ' << padded(cell, std::max<std::size_t>(17, report.scope.kernel.size()));
    }
    out << '\n';
  }
}

}  // namespace graze::fuzz
