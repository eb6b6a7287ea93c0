// The fuzzer's own changes of cases.
#include "fuzz/case_mutator.hpp"

#include <set>

#include "fuzz/case_text.hpp"
#include "fuzz/family.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

TEST_CASE("a mutation is a function of the case and the random stream, and changes most cases") {
  int changed = 0, all = 0;
  for (const Family& family : families()) {
    for (std::uint64_t index = 0; index < 200; ++index) {
      const Case<double> input = make<double>(family, 3, index).input;
      Case<double> once = input, again = input;
      Random random(5, family.name, index), same = random;
      mutate(once, random);
      mutate(again, same);
      CHECK(format_case(once) == format_case(again));
      CHECK(once.index() == input.index());
      changed += format_case(once) != format_case(input) ? 1 : 0;
      ++all;
    }
  }
  CHECK(changed > all / 2);
}

TEST_CASE("mutations reach corners, tangents and bounds from a plain case") {
  RayTriangle<float> query;
  query.ray = {{1, 1, 5}, {0, 0, -1}};
  query.triangle = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  std::set<std::string> seen;
  for (std::uint64_t index = 0; index < 2000; ++index) {
    Random random(9, "reach", index);
    Case<float> input = query;
    mutate(input, random);
    seen.insert(format_case(input));
  }
  CHECK(
      seen.contains("ray_triangle 0x1p+0 0x1p+0 0x1.4p+2 -0x1p+0 -0x1p+0 -0x1.4p+2 0x0p+0 0x0p+0 0x0p+0 0x1p+2 0x0p+0 0x0p+0 "
                    "0x0p+0 0x1p+2 0x0p+0"));
  CHECK(
      seen.contains("ray_triangle 0x1p+0 0x1p+0 0x1.4p+2 0x0p+0 0x0p+0 -0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+2 0x0p+0 0x0p+0 "
                    "0x0p+0 0x1p+2 0x0p+0 0x0p+0 0x1.4p+2"));
}
