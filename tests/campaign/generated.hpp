// Reports with made-up tallies, cut into parts as shards and interruptions would.
#pragma once

#include <string>
#include <vector>

#include "fuzz/random.hpp"
#include "fuzz/report/report.hpp"

namespace graze::fuzz {

/// What one case gave: a function of (row, index), so that every cut of a campaign tells the same.
inline void add_case(Part& part, std::size_t row, std::uint64_t index) {
  Random random(7, "generated-" + std::to_string(row), index);
  Comparison comparison;
  comparison.disagreement = static_cast<Disagreement>(random.one_in(3) ? random.below(disagreement_count - 1) : 0);
  comparison.has_numbers = random.one_in(2);
  if (comparison.disagreement == Disagreement::misrounded) {
    // Of few values, so that offenders of equal rank meet.
    comparison.error_ulps = random.one_in(8) ? 1.0 / 0.0 : static_cast<double>(random.below(4)) + 0.75;
  }
  if (random.one_in(5)) comparison.allowed.add(static_cast<Deviation>(random.below(deviation_count)));
  const auto describe = [&] {
    const FloatMode mode = index % 2 == 0 ? FloatMode::nearest : FloatMode::upward;
    return Offender{{}, 0, row % 2 == 0 ? "float" : "double", mode, "input " + std::to_string(index), "answer", "exact"};
  };
  part.tally.count_in(comparison);
  part.tally.offer(comparison, index, describe);
  if (random.one_in(16)) ++part.tally.oracles_compared;
  part.tally.skipped += random.one_in(9);
  if (row == 1) {
    ++part.rays;
    part.lost_rays += random.one_in(30);
  }
  part.input_hash += random.bits();
}

inline Part part_of(std::size_t row, Range range) {
  Part part;
  part.range = range;
  for (std::uint64_t i = range.from; i < range.to; ++i) add_case(part, row, i);
  return part;
}

/// Three rows of unlike length, one of them empty, nothing judged.
inline Report blank() {
  Report report;
  report.scope = {"0.0.0",
                  "made-up",
                  "for tests",
                  "--time-limit 7",
                  {},
                  1,
                  40,
                  16,
                  {FloatMode::nearest, FloatMode::upward},
                  {{"tetrahedron", 4, 17}},
                  "none",
                  "-O9"};
  report.cpus = {"abacus"};
  report.rows = {{"first", "float", false, 40}, {"second", "double", true, 23}, {"third", "float", true, 0, "no way in"}};
  return report;
}

/// A report that covers the first `done` cases of every row's share.
inline Report of_shard(const Shard& shard, std::uint64_t done = ~std::uint64_t{0}) {
  Report report = blank();
  if (shard.count > 1) report.shards.insert(shard);
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    Range range = shard.of(report.rows[i].planned);
    range.to = range.from + std::min(done, range.to - range.from);
    report.rows[i].cover(part_of(i, range));
  }
  return report;
}

/// The same report with nothing wrong in it and no obstacle.
inline Report cleaned(Report report) {
  for (Row& row : report.rows) {
    row.obstacle.clear();
    for (Part& part : row.parts) {
      const std::uint64_t cases = part.tally.answers;
      part.tally = {};
      part.tally.answers = part.tally.by_disagreement[0] = cases;
      part.lost_rays = 0;
    }
  }
  return report;
}

}  // namespace graze::fuzz
