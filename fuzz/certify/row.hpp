// A row of a campaign: one family or one way to aim at a mesh, in one precision, and which of its cases have been judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/certify/tally.hpp"

namespace graze::fuzz {

/// The numbers from, from + 1, ..., to - 1.
struct Range {
  std::uint64_t from = 0, to = 0;
  bool operator==(const Range&) const = default;
};

/// What was found on consecutive cases of a row.
struct Part {
  Range range;
  Tally tally;
  /// Of a mesh, whose cases are rays: rays that the subject answered, and of these the ones that met nothing where the exact
  /// answer is a hit.
  std::uint64_t rays = 0, lost_rays = 0;
  std::uint64_t input_hash = 0;  ///< of all inputs, added up

  /// Adds what was found on other cases; the range stays.
  void add(const Part& other);
  [[nodiscard]] bool is_clean() const { return tally.is_clean() && lost_rays == 0; }
};

struct Row {
  std::string name;       ///< the family, or "MESH: corners" and the like
  std::string precision;  ///< float or double
  bool is_mesh = false;
  std::uint64_t planned = 0;  ///< cases, or rays at the mesh
  std::string obstacle = {};  ///< of a mesh: why no ray could be aimed
  std::vector<Part> parts{};  ///< by ascending range; no two overlap

  /// Adds a part that overlaps none, and makes one of it and those that it touches.
  void cover(Part part);
  /// All parts as one, whose range is [0, planned).
  [[nodiscard]] Part total() const;
  [[nodiscard]] bool is_whole() const { return gaps({0, planned}).empty(); }
  /// What no part covers.
  [[nodiscard]] std::vector<Range> gaps(Range within) const;
};

}  // namespace graze::fuzz
