// Numbers as the reports write them.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/certify/shard.hpp"

namespace graze::fuzz {

/// As printf has it, up to 255 characters.
template <class... Args>
[[nodiscard]] std::string formatted(const char* format, Args... args) {
  char text[256];
  std::snprintf(text, sizeof text, format, args...);
  return text;
}

/// 1234567 as 1,234,567.
[[nodiscard]] inline std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

/// A correctly rounded number errs by at most half a unit; the exact error of a misrounded one is known.
[[nodiscard]] inline std::string worst_error(const Tally& tally) {
  return tally.misrounded == 0 ? "<= 0.5" : formatted("%.4g", tally.worst_ulps);
}

/// Where the errors of a bin of Tally::by_error lie, in ulps.
[[nodiscard]] inline std::string error_bin_name(std::size_t bin) {
  if (bin == 0) return "correctly rounded";
  if (bin == error_bins - 1) return "inf";
  if (bin == error_bins - 2) return ">= 2^63";
  return "< 2^" + std::to_string(bin - 1);
}

/// "1/4"
[[nodiscard]] inline std::string text_of(const Shard& shard) {
  return std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

/// What text_of writes.
[[nodiscard]] inline std::optional<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, shard.count);
  if (count.ec != std::errc() || count.ptr != end || shard.number < 1 || shard.number > shard.count) return std::nullopt;
  return shard;
}

/// "case 7" or "cases 0 to 99": both ends included.
[[nodiscard]] inline std::string text_of(const Range& range) {
  if (range.to - range.from == 1) return "case " + grouped(range.from);
  return "cases " + grouped(range.from) + " to " + grouped(range.to - 1);
}

}  // namespace graze::fuzz
