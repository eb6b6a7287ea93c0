// A share of a campaign, for one of several processes or machines.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

#include "fuzz/certify/row.hpp"

namespace graze::fuzz {

/// The number-th of `count` equal shares; 1 <= number <= count.
struct Shard {
  std::uint64_t number = 1, count = 1;

  /// The share of a row of n cases. The shares of all shards are disjoint and make up the row; no two differ by more than one.
  [[nodiscard]] Range of(std::uint64_t n) const {
    const auto start = [&](std::uint64_t i) { return n / count * i + std::min(i, n % count); };
    return {start(number - 1), start(number)};
  }
  /// By count, then number.
  friend auto operator<=>(const Shard& a, const Shard& b) {
    return a.count != b.count ? a.count <=> b.count : a.number <=> b.number;
  }
  bool operator==(const Shard&) const = default;
};

}  // namespace graze::fuzz
