// A campaign: families and meshes, in both precisions, on all cores; the same result for any number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/certify/check.hpp"
#include "fuzz/family.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

struct Row {
  std::string name;       ///< the family, or "MESH: corners" and the like
  std::string precision;  ///< float or double
  Tally tally;
  bool is_mesh = false;
  /// Of a mesh: rays aimed, and rays that met nothing where the exact answer is a hit.
  std::uint64_t rays = 0, lost_rays = 0;
  /// Of a mesh: why no ray could be aimed.
  std::string obstacle = {};
};

struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t cases = 10000;  ///< per family and precision
  std::vector<const Family*> families;
  std::vector<Mesh> meshes;  ///< closed
};

/// What runs meanwhile may ask: how much is done, and to stop.
struct Progress {
  std::atomic<std::uint64_t> cases_done{0};
  std::uint64_t cases_planned = 0;
  const std::atomic<bool>* stop = nullptr;
  [[nodiscard]] bool is_stopped() const { return stop != nullptr && *stop; }
};

/// Runs everything, families first, each row in the order given, float before double. Stopped early, the rows hold what was
/// done.
[[nodiscard]] std::vector<Row> run(const Campaign& campaign, const Judges& judges, Progress& progress);

}  // namespace graze::fuzz
