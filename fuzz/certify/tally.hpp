// What a campaign counts: a row for each family or mesh, with its worst offenders.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/certify/comparison.hpp"
#include "fuzz/float_mode.hpp"

namespace graze::fuzz {

/// A case on which the subject disagrees, as text that replays it.
struct Offender {
  Comparison comparison;
  std::uint64_t index = 0;              ///< the case's number in its family or mesh
  std::string precision;                ///< float or double
  FloatMode mode = FloatMode::nearest;  ///< in which the subject was asked
  std::string input;                    ///< the case line, in hexadecimal
  std::string answer, truth;            ///< answer lines with details; of an answer that failed, how
};

/// Where an error is counted: 0 for a correctly rounded answer, 1 below one ulp, 2 for [1, 2), 3 for [2, 4), up to 64 for
/// [2^62, 2^63), 65 for more, 66 for an infinity or NaN.
inline constexpr std::size_t error_bins = 67;
[[nodiscard]] std::size_t error_bin(double ulps);

struct Tally {
  static constexpr std::size_t kept_offenders = 3;

  std::uint64_t answers = 0;                                        ///< asked for, whether or not one came
  std::uint64_t skipped = 0;                                        ///< queries that the subject does not offer
  std::array<std::uint64_t, disagreement_count> by_disagreement{};  ///< indexed by Disagreement; its worst counts
  std::array<std::uint64_t, deviation_count> by_deviation{};        ///< indexed by Deviation: allowed for, because declared
  std::array<std::uint64_t, error_bins> by_error{};                 ///< answers with numbers, by the worst of them
  std::uint64_t misrounded = 0;        ///< answers in which a number is not the correctly rounded one, whatever else is wrong
  double worst_ulps = 0;               ///< of those numbers
  std::uint64_t oracles_compared = 0;  ///< cases that the second oracle was asked about too
  std::vector<Offender> offenders;     ///< the worst first, of equal ones the lowest index first

  [[nodiscard]] std::uint64_t count(Disagreement d) const { return by_disagreement[static_cast<std::size_t>(d)]; }
  [[nodiscard]] std::uint64_t count(Deviation d) const { return by_deviation[static_cast<std::size_t>(d)]; }
  /// Decisions that are wrong in any way: kind, side, status, root, order, origin, facing.
  [[nodiscard]] std::uint64_t wrong_kinds() const;
  /// Nothing disagrees beyond what the subject declares.
  [[nodiscard]] bool is_clean() const;

  /// Counts the comparison of an answer.
  void count_in(const Comparison& c);
  /// Keeps it among the worst offenders where it is one; `describe` makes the Offender's text and is called only where it may
  /// be kept.
  template <class Describe>
  void offer(const Comparison& c, std::uint64_t index, Describe describe) {
    if (c.disagreement == Disagreement::none) return;
    if (offenders.size() == kept_offenders && is_behind(c, index, offenders.back())) return;
    Offender offender = describe();
    offender.comparison = c;
    offender.index = index;
    keep(std::move(offender));
  }

  /// The two oracles differ: the certifier itself is wrong. `answer` is the second oracle's.
  void keep_oracle_difference(Offender offender, std::uint64_t index);

  /// Adds another part of the same row. Parts may be merged in any order and grouping, with the same result.
  void merge(const Tally& other);

 private:
  /// Whether it is less bad than the one that is kept, or as bad and later.
  static bool is_behind(const Comparison& c, std::uint64_t index, const Offender& kept);
  void keep(Offender offender);
};

}  // namespace graze::fuzz
