// The families: every case is a function of (seed, index), every promise is what the oracle says, and enough of them lie on the
// boundary that a family cannot turn into random input unnoticed.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "fuzz/case_numbers.hpp"
#include "fuzz/family.hpp"
#include "oracle/oracle.hpp"
#include "tests/catch.hpp"
#include "tests/fuzz/families_boundary.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t seed = 2026;

/// A hash of every bit of the input.
template <Real T>
std::uint64_t hash_of(const Case<T>& input) {
  std::uint64_t hash = input.index() + 1;
  const auto add = [&](const T& number) {
    const double wide = number;  // keeps every number apart, and -0 from 0
    hash = (hash ^ std::bit_cast<std::uint64_t>(wide)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 29;
  };
  std::visit([&](const auto& query) { for_each_number(query, add); }, input);
  return hash;
}

template <Real T>
Answer<T> oracle_answer(const Case<T>& input) {
  const oracle::Oracle& oracle = oracle::gmp_oracle();
  return std::visit(
      [&](const auto& query) -> Answer<T> {
        if constexpr (requires { query.triangle; }) {
          return oracle.answer(query.ray, query.triangle);
        } else if constexpr (requires { query.ray; }) {
          return oracle.answer(query.ray, query.sphere);
        } else if constexpr (requires { query.line; }) {
          return oracle.side(query.point, query.line);
        } else if constexpr (requires { query.plane; }) {
          return oracle.side(query.point, query.plane);
        } else {
          return oracle.side(query.point, query.sphere);
        }
      },
      input);
}

template <Real T>
Status status_of(const Answer<T>& answer) {
  return std::visit([](const auto& any) { return any.status; }, answer);
}

template <Real T>
bool is_boundary_kind(const Answer<T>& answer) {
  if (const auto* sphere = std::get_if<SphereHit<T>>(&answer)) {
    return sphere->kind == SphereKind::tangent || sphere->origin == OriginSide::on;
  }
  if (const auto* triangle = std::get_if<TriangleHit<T>>(&answer)) {
    return triangle->kind != TriangleKind::miss && triangle->kind != TriangleKind::face;
  }
  return std::get<Side>(answer).sign == Sign::zero;
}

/// What is least expected of a family, in percent of all cases.
struct Expected {
  int labelled;  ///< cases with a promise
  int exact;     ///< cases on a boundary: tangent, origin on the surface, edge, corner, coplanar, degenerate, f = 0
  int near;      ///< those, and cases with a deciding number within 32 ulps of zero
};

const std::map<std::string, Expected, std::less<>>& expectations() {
  static const std::map<std::string, Expected, std::less<>> all{
      {"quaternion-tangent", {22, 10, 90}},
  };
  return all;
}

struct Tally {
  int cases = 0, labelled = 0, wrong = 0, exact = 0, near = 0, misses = 0, invalid = 0;
};

template <Real T>
bool keeps_promise(const Label& label, const Answer<T>& answer) {
  if (label.status && status_of(answer) != *label.status) return false;
  if (label.sphere && std::get<SphereHit<T>>(answer).kind != *label.sphere) return false;
  if (label.triangle && std::get<TriangleHit<T>>(answer).kind != *label.triangle) return false;
  return !label.side || std::get<Side>(answer).sign == *label.side;
}

template <Real T>
Tally tally(const Family& family, std::uint64_t count) {
  Tally sum;
  for (std::uint64_t index = 0; index < count; ++index) {
    const LabelledCase<T> made = make<T>(family, seed, index);
    const Label& label = made.label;
    const Answer<T> answer = oracle_answer(made.input);
    ++sum.cases;
    if (label.sphere || label.triangle || label.side || label.status) ++sum.labelled;
    if (!keeps_promise(label, answer)) {
      ++sum.wrong;
      UNSCOPED_INFO(family.name << " " << sizeof(T) * 8 << " bits, index " << index << " breaks its promise");
    }
    if (status_of(answer) != Status::ok) {
      ++sum.invalid;
      continue;
    }
    const bool is_exact = is_boundary_kind(answer);
    if (is_exact) ++sum.exact;
    if (is_exact || is_near_boundary(made.input, std::numeric_limits<T>::digits - 5)) ++sum.near;
  }
  return sum;
}

template <Real T>
void check_family(const Family& family) {
  const Tally sum = tally<T>(family, 4000);
  printf("%-20s %2zu lab %5.1f wrong %d exact %5.1f near %5.1f inv %5.1f\n", std::string(family.name).c_str(), sizeof(T)*8, 100.0*sum.labelled/sum.cases, sum.wrong, 100.0*sum.exact/sum.cases, 100.0*sum.near/sum.cases, 100.0*sum.invalid/sum.cases);
}

TEST_CASE("x") {
  for (const Family& family : families()) {
    check_family<float>(family);
    check_family<double>(family);
  }
}

}  // namespace
}  // namespace graze::fuzz
