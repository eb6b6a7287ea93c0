// Both oracles say the same of the families' cases, bit by bit, and both confirm every label. A stretch of each family here;
// 10,000 cases a precision, which take minutes, by:
//   build/release/bin/test_oracle "[exhaustive]"
#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/family.hpp"
#include "fuzz/same_bits.hpp"
#include "tests/catch.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t seed = 1;

template <Real T>
bool keeps_promise(const Label& label, const Answer<T>& answer) {
  const Status status = std::visit([](const auto& any) { return any.status; }, answer);
  if (label.status && status != *label.status) return false;
  if (label.sphere && std::get<SphereHit<T>>(answer).kind != *label.sphere) return false;
  if (label.triangle && std::get<TriangleHit<T>>(answer).kind != *label.triangle) return false;
  return !label.side || std::get<Side>(answer).sign == *label.side;
}

struct Counts {
  std::uint64_t cases = 0, labelled = 0, differ = 0, broken = 0;
};

template <Real T>
void compare_oracles(const Family& family, std::uint64_t count, Counts& counts) {
  for (std::uint64_t index = 0; index < count; ++index) {
    const LabelledCase<T> made = make<T>(family, seed, index);
    const Answer<T> first = answer_of(oracle::gmp_oracle(), made.input), second = answer_of(oracle::cgal_oracle(), made.input);
    ++counts.cases;
    const Label& label = made.label;
    if (label.sphere || label.triangle || label.side || label.status) ++counts.labelled;
    const bool is_same = same_bits(first, second);
    const bool is_kept = keeps_promise(label, first) && keeps_promise(label, second);
    counts.differ += is_same ? 0 : 1;
    counts.broken += is_kept ? 0 : 1;
    if (is_same && is_kept) continue;
    UNSCOPED_INFO(family.name << ", case " << index << ": " << format_case(made.input));
    CHECK((is_same && is_kept));
  }
}

/// `count` cases of each family and precision.
Counts compare_all(std::uint64_t count) {
  Counts counts;
  for (const Family& family : families()) {
    compare_oracles<float>(family, count, counts);
    compare_oracles<double>(family, count, counts);
  }
  return counts;
}

TEST_CASE("Both oracles confirm the families' labels") {
  const Counts counts = compare_all(200);
  CHECK(counts.cases == families().size() * 400);
  CHECK(counts.labelled * 5 > counts.cases);
}

TEST_CASE("Both oracles confirm every family's labels on 10,000 cases a precision", "[.exhaustive]") {
  const Counts counts = compare_all(10000);
  WARN(counts.cases << " cases, " << counts.labelled << " with a label, " << counts.differ << " on which the oracles differ, "
                    << counts.broken << " labels denied");
  CHECK(counts.differ + counts.broken == 0);
}

}  // namespace
}  // namespace graze::fuzz
