// The laws of merging, over made-up tallies: any order, grouping and repetition gives the bytes that one process gives.
#include "fuzz/report/merge.hpp"

#include <algorithm>

#include "fuzz/report/json.hpp"
#include "tests/campaign/generated.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

std::string bytes(const Report& report) {
  return to_json(report).dump();
}

Report merged(Report a, const Report& b) {
  const std::string wrong = merge(a, b);
  INFO(wrong);
  REQUIRE(wrong.empty());
  return a;
}

/// A shard, whole or broken off.
Report drawn(Random& random, std::uint64_t count) {
  const std::uint64_t number = 1 + random.below(count);
  return of_shard({number, count}, random.one_in(2) ? random.below(12) : ~std::uint64_t{0});
}

TEST_CASE("all shards merged are byte for byte the unsharded run") {
  const std::string whole = bytes(of_shard({1, 1}));
  for (std::uint64_t count = 1; count <= 40; ++count) {
    std::vector<std::uint64_t> numbers(count);
    for (std::uint64_t i = 0; i < count; ++i) numbers[i] = i + 1;
    Random random(count, "order", 0);
    for (std::uint64_t i = count; i > 1; --i) std::swap(numbers[i - 1], numbers[random.below(i)]);
    Report sum = of_shard({numbers[0], count});
    for (std::uint64_t i = 1; i < count; ++i) {
      REQUIRE_FALSE(missing(sum).empty());
      sum = merged(sum, of_shard({numbers[i], count}));
    }
    REQUIRE(missing(sum).empty());
    REQUIRE(bytes(sum) == whole);
  }
}

TEST_CASE("merging is associative, commutative and idempotent, with broken-off shards too") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed, "laws", 0);
    const std::uint64_t count = 1 + random.below(4);
    const Report a = drawn(random, count), b = drawn(random, count), c = drawn(random, count);
    REQUIRE(bytes(merged(a, a)) == bytes(a));
    REQUIRE(bytes(merged(a, b)) == bytes(merged(b, a)));
    REQUIRE(bytes(merged(merged(a, b), c)) == bytes(merged(a, merged(b, c))));
    REQUIRE(bytes(merged(merged(a, b), merged(b, c))) == bytes(merged(merged(a, b), c)));
  }
}

TEST_CASE("a whole report takes up what it holds already") {
  const Report whole = of_shard({1, 1});
  REQUIRE(bytes(merged(whole, of_shard({2, 3}))) == bytes(whole));
  REQUIRE(bytes(merged(of_shard({2, 3}, 5), whole)) == bytes(whole));
  REQUIRE(bytes(merged(merged(of_shard({1, 3}), of_shard({2, 3})), whole)) == bytes(whole));
}

TEST_CASE("processors that took part are all told") {
  Report other = of_shard({2, 2});
  other.cpus = {"slide rule"};
  REQUIRE(merged(of_shard({1, 2}), other).cpus == std::set<std::string>{"abacus", "slide rule"});
}

TEST_CASE("reports of other campaigns are refused by the name of the field, and change nothing") {
  const Report one = of_shard({1, 2});
  const auto refused = [&](auto change, const std::string& names) {
    Report other = of_shard({2, 2});
    change(other);
    Report sum = one;
    CHECK(merge(sum, other).starts_with(names));
    CHECK(bytes(sum) == bytes(one));
  };
  refused([](Report& r) { r.scope.seed = 2; }, "scope/seed: 1 and 2");
  refused([](Report& r) { r.scope.version = "0.0.1"; }, "version: ");
  refused([](Report& r) { r.scope.kernel = "other"; }, "kernel/name: \"made-up\" and \"other\"");
  refused([](Report& r) { r.scope.declared.set.add(Deviation::no_root); }, "kernel/declares");
  refused([](Report& r) { r.scope.declared.t_ulps = 3; }, "kernel/");
  refused([](Report& r) { r.scope.options = "--time-limit 8"; }, "kernel/options: ");
  refused([](Report& r) { r.scope.modes.pop_back(); }, "scope/float_modes/1: \"up\" and missing");
  refused([](Report& r) { r.scope.second_oracle_every = 1; }, "scope/second_oracle_every: 16 and 1");
  refused([](Report& r) { r.scope.meshes[0].hash = 18; }, "scope/meshes/0/hash: ");
  refused([](Report& r) { r.scope.compiler = "other"; }, "scope/compiler: ");
  refused([](Report& r) { r.scope.flags = "-O0"; }, "scope/flags: ");
  refused([](Report& r) { r.rows.pop_back(); }, "rows/2: ");
  refused([](Report& r) { r.rows[0].planned = 41; }, "rows/0/planned: 40 and 41");
}

TEST_CASE("the same part with another content is refused by row, cases and field") {
  const auto refused = [](auto change, const std::string& names) {
    Report one = of_shard({1, 2}), other = of_shard({1, 2});
    change(other.rows[0].parts[0]);
    const std::string wrong = merge(one, other);
    INFO(wrong);
    CHECK(wrong.starts_with("first, float, cases 0 to 19: " + names));
  };
  refused([](Part& p) { ++p.tally.answers; }, "answers: ");
  refused([](Part& p) { ++p.tally.by_disagreement[8]; }, "disagreements/failed: ");
  refused([](Part& p) { ++p.input_hash; }, "input_hash: ");
  refused([](Part& p) { p.tally.offenders[0].answer = "another"; }, "offenders/0/answer: ");
  refused([](Part& p) { p.tally.offenders[0].mode = FloatMode::downward; }, "offenders/0/float_mode: ");
}

TEST_CASE("a part that does not fit into a greater one is refused by field") {
  const auto refused = [](auto change, const std::string& names) {
    Report part = of_shard({2, 4});
    change(part.rows[0].parts[0]);
    Report whole = of_shard({1, 1});
    const std::string place = "first, float, cases 10 to 19: ";
    const std::string wrong = merge(whole, part);
    INFO(names << " wanted, said: " << wrong);
    CHECK(wrong.starts_with(place + names));
    // The other way round it is the greater part that is added.
    CHECK(merge(part, of_shard({1, 1})).starts_with("first, float, cases 0 to 39: " + names));
  };
  refused([](Part& p) { p.tally.answers = 41; }, "answers: 40 in the greater part and 41 in the lesser");
  refused([](Part& p) { p.tally.by_deviation[3] = 41; }, "allowed_deviations/");
  refused(
      [](Part& p) {
        p.tally.offenders[0].comparison.disagreement = Disagreement::oracles;
        p.tally.offenders[0].index = 11;
      },
      "offenders/0/");
}

TEST_CASE("parts of unlike splits that overlap cannot be added") {
  Report sum = of_shard({1, 2});
  CHECK(merge(sum, of_shard({2, 3})).starts_with("first, float, cases 14 to 26: overlap cases 0 to 19 "));
  // Those that do not overlap can.
  CHECK(bytes(merged(merged(of_shard({1, 2}), of_shard({3, 4})), of_shard({4, 4}))) == bytes(of_shard({1, 1})));
}

TEST_CASE("what is missing is named") {
  CHECK(missing(of_shard({1, 1})).empty());
  CHECK(missing(of_shard({1, 3})) == "shards 2/3, 3/3");
  CHECK(missing(merged(of_shard({1, 3}), of_shard({2, 3}, 2))) == "shards 2/3 (begun), 3/3");
  CHECK(missing(of_shard({1, 1}, 30)) == "cases 30 to 39 of first, float");
  CHECK(missing(of_shard({1, 1}, 22)) == "cases 22 to 39 of first, float, and parts of 1 more rows");
}

TEST_CASE("the verdict: a fail stands, a pass wants what was to be done to be done") {
  CHECK(of_shard({1, 2}).verdict() == Verdict::fail);
  CHECK(cleaned(of_shard({1, 1})).verdict() == Verdict::pass);
  CHECK(cleaned(of_shard({1, 2})).verdict() == Verdict::pass);
  CHECK(cleaned(of_shard({1, 2}, 5)).verdict() == Verdict::incomplete);
  CHECK(cleaned(of_shard({1, 1}, 5)).verdict() == Verdict::incomplete);
  Report lost = cleaned(of_shard({1, 1}));
  lost.rows[1].parts[0].lost_rays = 1;
  CHECK(lost.verdict() == Verdict::fail);
  Report blocked = cleaned(of_shard({1, 1}));
  blocked.rows[2].obstacle = "no way in";
  CHECK(blocked.verdict() == Verdict::incomplete);
}

}  // namespace
}  // namespace graze::fuzz
