// Real campaigns: threads, shards, stops and restarts do not show in the report.
#include "fuzz/report/json.hpp"
#include "fuzz/report/merge.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

const Judges judges{{find_subject("cramer")}, oracle::gmp_oracle(), oracle::cgal_oracle(), 16};

const Plan& plan() {
  static const Campaign campaign{3, 700, {find_family("edge-corner"), find_family("rounding")}, {icosphere(1)}};
  static const Plan plan(campaign);
  return plan;
}

Report blank(const Shard& shard) {
  const Campaign campaign{3, 700, {}, {icosphere(1)}};
  return blank_report(campaign, plan(), judges, shard);
}

/// Goes on with the report until it is done, or `stop` is set.
void go_on(Report& report, const Shard& shard, const std::atomic<bool>* stop = nullptr) {
  Ledger ledger(report.rows);
  Progress progress;
  progress.stop = stop;
  run(plan(), judges, shard, ledger, progress);
  report.rows = ledger.rows();
  if (stop == nullptr) REQUIRE(progress.cases_done == progress.cases_planned);
}

Report done(const Shard& shard) {
  Report report = blank(shard);
  go_on(report, shard);
  return report;
}

TEST_CASE("shards of a real campaign merge to the bytes of one run") {
  const Report whole = done({});
  REQUIRE(whole.is_whole());
  REQUIRE(whole.verdict() == Verdict::fail);
  Report sum = done({1, 3});
  for (const std::uint64_t number : {3, 2}) REQUIRE(merge(sum, done({number, 3})).empty());
  REQUIRE(to_json(sum).dump() == to_json(whole).dump());
}

TEST_CASE("a campaign that is cut off goes on to the same bytes") {
  Report report = blank({});
  // What a broken-off run left: some pieces of some rows, judged by no other way.
  for (std::size_t row = 0; row < report.rows.size(); row += 2) {
    for (const Range piece : {Range{0, 5}, Range{11, 12}, Range{30, 41}}) {
      Part part{{piece.from, piece.from}, {}};
      plan().judge(row, piece, judges, part);
      report.rows[row].cover(part);
    }
  }
  REQUIRE_FALSE(report.is_finished());
  go_on(report, {});
  REQUIRE(to_json(report).dump() == to_json(done({})).dump());
}

TEST_CASE("a stop is heeded at once, and what is covered was judged") {
  const std::atomic<bool> stop = true;
  Report report = blank({});
  go_on(report, {}, &stop);
  REQUIRE(report.total().tally.answers == 0);
  REQUIRE(report.verdict() == Verdict::incomplete);
}

TEST_CASE("the hash of the inputs is one of inputs, not of the kernel, and changes with the seed") {
  const auto hash = [](std::uint64_t seed, const char* kernel) {
    const Campaign campaign{seed, 50, {find_family("coplanar")}, {icosphere(1)}};
    const Plan other(campaign);
    const Judges by{{find_subject(kernel)}, judges.first, judges.second, 0};
    Ledger ledger(other.rows());
    Progress progress;
    run(other, by, {}, ledger, progress);
    std::vector<std::uint64_t> hashes;
    // Rays between corners are the mesh's own: no seed draws them.
    for (const Row& row : ledger.rows()) {
      const bool is_of_mesh_alone = row.name.ends_with("corner to corner") || row.name.ends_with("along edges");
      if (!is_of_mesh_alone) hashes.push_back(row.total().input_hash);
    }
    return hashes;
  };
  CHECK(hash(1, "graze") == hash(1, "cramer"));
  CHECK(hash(1, "graze") == hash(1, "textbook-naive"));
  const auto one = hash(1, "graze"), two = hash(2, "graze");
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i] != two[i]);
}

}  // namespace
}  // namespace graze::fuzz
