// What a campaign counts: a row for each family or mesh, with its worst offenders.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/certify/comparison.hpp"

namespace graze::fuzz {

/// A case on which the subject disagrees, as text that replays it.
struct Offender {
  Comparison comparison;
  std::uint64_t index = 0;    ///< the case's number in its family or mesh
  std::string precision;      ///< float or double
  std::string input;          ///< the case line, in hexadecimal
  std::string answer, truth;  ///< answer lines with details
};

struct Tally {
  static constexpr std::size_t kept_offenders = 3;

  std::uint64_t cases = 0;                         ///< compared
  std::uint64_t skipped = 0;                       ///< queries that the subject does not offer
  std::array<std::uint64_t, 7> by_disagreement{};  ///< indexed by Disagreement
  std::uint64_t misrounded = 0;        ///< answers in which a number is not the correctly rounded one, whatever else is wrong
  double worst_ulps = 0;               ///< of those numbers
  std::uint64_t oracles_compared = 0;  ///< cases that the second oracle was asked about too
  std::vector<Offender> offenders;     ///< the worst first, of equal ones the lowest index first

  [[nodiscard]] std::uint64_t count(Disagreement d) const { return by_disagreement[static_cast<std::size_t>(d)]; }
  /// Decisions that are wrong in any way: kind, side, status, root, origin, facing.
  [[nodiscard]] std::uint64_t wrong_kinds() const {
    return count(Disagreement::wrong_detail) + count(Disagreement::wrong_kind) + count(Disagreement::false_hit) +
           count(Disagreement::lost_hit);
  }
  [[nodiscard]] bool is_clean() const { return wrong_kinds() == 0 && misrounded == 0 && count(Disagreement::oracles) == 0; }

  /// Counts a comparison; `describe` makes the Offender's text and is called only where it is kept.
  template <class Describe>
  void add(const Comparison& c, std::uint64_t index, Describe describe) {
    ++cases;
    ++by_disagreement[static_cast<std::size_t>(c.disagreement)];
    if (c.error_ulps > 0) ++misrounded;
    if (c.error_ulps > worst_ulps) worst_ulps = c.error_ulps;
    if (c.disagreement == Disagreement::none) return;
    if (offenders.size() == kept_offenders && !is_worse(c, index, offenders.back())) return;
    Offender offender = describe();
    offender.comparison = c;
    offender.index = index;
    keep(std::move(offender));
  }

  /// The two oracles differ: the certifier itself is wrong. `answer` is the second oracle's.
  void keep_oracle_difference(Offender offender, std::uint64_t index);

  /// Adds another part of the same row.
  void merge(const Tally& other);

 private:
  static bool is_worse(const Comparison& c, std::uint64_t index, const Offender& than);
  void keep(Offender offender);
};

}  // namespace graze::fuzz
