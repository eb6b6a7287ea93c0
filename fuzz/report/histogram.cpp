#include "fuzz/report/histogram.hpp"

#include <algorithm>
#include <cmath>

#include "fuzz/report/markup.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

constexpr double left = 44, right = 690, top = 12, bottom = 168;

/// What stands below a bin, if anything.
std::string tick(std::size_t bin) {
  if (bin == 0) return "≤½";
  if (bin == error_bins - 1) return "inf";
  if (bin < 2 || bin == error_bins - 2 || (bin - 2) % 10 != 0) return {};
  return bin == 2 ? "1" : "2^" + std::to_string(bin - 2);
}

}  // namespace

std::string error_histogram(const Tally& tally) {
  const std::uint64_t most = *std::max_element(tally.by_error.begin(), tally.by_error.end());
  if (most == 0) return {};
  const double decades = std::max(1.0, std::ceil(std::log10(static_cast<double>(most) + 1)));
  // A bar for one answer is to be seen.
  const auto y = [&](double count) { return bottom - 3 - (bottom - top - 3) * std::log10(count) / decades; };
  constexpr double step = (right - left) / error_bins;
  std::string markup =
      "<svg class='chart' viewBox='0 0 700 190' role='img' aria-label='Answers by the error of their worst number'>";
  for (double decade = 0; decade <= decades; ++decade) {
    const double at = y(std::pow(10, decade));
    markup += formatted("<line class='axis' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", left, at, right, at);
    if (decades <= 5 || std::fmod(decade, 2) == 0) {
      markup += formatted("<text x='%.1f' y='%.1f' text-anchor='end'>", left - 5, at + 4) +
                (decade < 6 ? grouped(static_cast<std::uint64_t>(std::pow(10, decade))) : formatted("1e%.0f", decade)) +
                "</text>";
    }
  }
  for (std::size_t bin = 0; bin < error_bins; ++bin) {
    const double x = left + static_cast<double>(bin) * step;
    if (const std::string name = tick(bin); !name.empty()) {
      markup += formatted("<text x='%.1f' y='%.1f' text-anchor='middle'>", x + step / 2, bottom + 15) + name + "</text>";
    }
    if (tally.by_error[bin] == 0) continue;
    const double height = bottom - y(static_cast<double>(tally.by_error[bin]));
    markup += formatted("<rect class='bar' x='%.1f' y='%.1f' width='%.1f' height='%.1f'><title>", x + 0.5, bottom - height,
                        step - 1, height) +
              escaped(error_bin_name(bin) + ": " + grouped(tally.by_error[bin])) + "</title></rect>";
  }
  return markup + "</svg>\n";
}

}  // namespace graze::fuzz
