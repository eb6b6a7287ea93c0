// A campaign: families and meshes, in both precisions, on all cores; the same result for any number of threads, processes and
// interruptions.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "fuzz/certify/check.hpp"
#include "fuzz/certify/row.hpp"
#include "fuzz/certify/shard.hpp"
#include "fuzz/family.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

/// CGAL confirms every so-many-th case, unless said otherwise.
inline constexpr std::uint64_t default_second_oracle_every = 16;

struct Campaign {
  std::uint64_t seed = 1;
  std::uint64_t cases = 10000;  ///< per family and precision
  std::vector<const Family*> families;
  std::vector<Mesh> meshes;  ///< closed
};

/// All families, and rays at two meshes that are made.
[[nodiscard]] Campaign default_campaign();

/// The rows of a campaign and how to judge each of their cases. Refers to the families.
class Plan {
 public:
  /// Families first, each row in the order given, float before double. Of every mesh an inside point is sought, which takes a
  /// moment.
  explicit Plan(const Campaign& campaign);

  /// All rows, nothing judged.
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
  /// Judges cases of a row into the part, and puts them at the end of its range.
  void judge(std::size_t row, Range cases, const Judges& judges, Part& part) const {
    judges_[row](cases, judges, part);
    part.range.to = cases.to;
  }

 private:
  using Judge = std::function<void(Range cases, const Judges&, Part&)>;
  template <Real T>
  void plan_family(const Family& family, const Campaign& campaign);
  template <Real T>
  void plan_mesh(const Mesh& mesh, std::uint64_t seed);

  std::vector<Row> rows_;
  std::vector<Judge> judges_;
};

/// Rows that fill while they may be read, from any thread.
class Ledger {
 public:
  explicit Ledger(std::vector<Row> rows) : rows_(std::move(rows)) {}
  [[nodiscard]] std::vector<Row> rows() const {
    const std::scoped_lock lock(mutex_);
    return rows_;
  }
  void cover(std::size_t row, Part part) {
    const std::scoped_lock lock(mutex_);
    rows_[row].cover(std::move(part));
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Row> rows_;
};

/// What runs meanwhile may ask: how much is done, and to stop.
struct Progress {
  std::atomic<std::uint64_t> cases_done{0};
  std::atomic<std::uint64_t> cases_planned{0};  ///< of this run: what is covered already is not counted
  std::atomic<std::uint64_t> discrepancies{0};  ///< wrong answers and lost rays, whole units of work after they are done
  const std::atomic<bool>* stop = nullptr;
  [[nodiscard]] bool is_stopped() const { return stop != nullptr && *stop; }
};

/// Judges what the ledger does not cover of the shard. Stopped early, it covers what was done, to the case.
void run(const Plan& plan, const Judges& judges, const Shard& shard, Ledger& ledger, Progress& progress);

}  // namespace graze::fuzz
