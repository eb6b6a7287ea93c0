// Rows that are covered piece by piece, and shares.
#include <algorithm>

#include "fuzz/report/numbers.hpp"
#include "tests/campaign/generated.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

std::vector<Range> ranges(const Row& row) {
  std::vector<Range> all;
  for (const Part& part : row.parts) all.push_back(part.range);
  return all;
}

TEST_CASE("the shares of a row are disjoint, make it up, and differ by one at most") {
  for (const std::uint64_t n : {0ull, 1ull, 5ull, 1000ull, 1001ull, 18446744073709551615ull}) {
    for (const std::uint64_t count : {1ull, 2ull, 3ull, 7ull, 1000ull}) {
      std::uint64_t end = 0;
      for (std::uint64_t number = 1; number <= count; ++number) {
        const Range share = Shard{number, count}.of(n);
        REQUIRE(share.from == end);
        REQUIRE(share.to - share.from - n / count <= 1);
        end = share.to;
      }
      REQUIRE(end == n);
    }
  }
}

TEST_CASE("a shard is written as it is read, and nothing else is one") {
  CHECK(parse_shard("3/7") == Shard{3, 7});
  CHECK(text_of(Shard{3, 7}) == "3/7");
  for (const char* text :
       {"", "3", "3/", "/7", "0/7", "8/7", "3/0", "-1/7", "3/7 ", " 3/7", "3/7/9", "3.5/7", "99999999999999999999/1"}) {
    CHECK_FALSE(parse_shard(text));
  }
}

TEST_CASE("parts that touch become one, in any order") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Row row{"row", "float", false, 40};
    std::vector<Range> pieces;
    Random random(seed, "pieces", 0);
    for (std::uint64_t from = 0; from < 40;) {
      const std::uint64_t to = std::min<std::uint64_t>(40, from + 1 + random.below(9));
      pieces.push_back({from, to});
      from = to;
    }
    while (!pieces.empty()) {
      const auto next = pieces.begin() + static_cast<std::ptrdiff_t>(random.below(pieces.size()));
      row.cover(part_of(0, *next));
      pieces.erase(next);
      std::uint64_t open = 0, covered = 0;
      for (const Range gap : row.gaps({0, 40})) open += gap.to - gap.from;
      for (const Range piece : pieces) covered += piece.to - piece.from;
      REQUIRE(open == covered);
    }
    REQUIRE(ranges(row) == std::vector<Range>{{0, 40}});
    const Part whole = part_of(0, {0, 40});
    REQUIRE(row.parts[0].tally.by_disagreement == whole.tally.by_disagreement);
    REQUIRE(row.parts[0].input_hash == whole.input_hash);
    REQUIRE(row.is_whole());
  }
}

TEST_CASE("gaps are told within a range") {
  Row row{"row", "float", false, 100};
  row.cover(part_of(0, {10, 20}));
  row.cover(part_of(0, {30, 40}));
  CHECK(row.gaps({0, 100}) == std::vector<Range>{{0, 10}, {20, 30}, {40, 100}});
  CHECK(row.gaps({15, 35}) == std::vector<Range>{{20, 30}});
  CHECK(row.gaps({12, 18}).empty());
  CHECK(row.gaps({50, 60}) == std::vector<Range>{{50, 60}});
  row.cover(part_of(0, {5, 5}));
  CHECK(row.parts.size() == 2);
}

}  // namespace
}  // namespace graze::fuzz
