// Counting what a query does, or not at all: queries are compiled once with each.
#pragma once

#include "graze/scene/query.hpp"

namespace graze::scene {

/// Counts nothing, at no cost.
struct Silent {
  template <std::uint64_t Statistics::*>
  void add(std::uint64_t) const noexcept {}
};

struct Counting {
  Statistics& statistics;

  template <std::uint64_t Statistics::*Member>
  void add(std::uint64_t n) const noexcept {
    statistics.*Member += n;
  }
};

}  // namespace graze::scene
