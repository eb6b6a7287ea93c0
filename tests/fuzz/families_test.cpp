// The families: every case is a function of (seed, index), every promise is what the oracle says, and enough of them lie on the
// boundary that a family cannot turn into random input unnoticed.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <unordered_set>
#include <vector>

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

/// What is least expected of a family, in percent of all cases; about nine tenths of what it gives.
struct Expected {
  std::string_view family;
  int labelled;  ///< cases with a promise
  int exact;     ///< cases on a boundary: tangent, origin on the surface, edge, corner, coplanar, degenerate, f = 0
  int near;      ///< those, and cases with a deciding number within 32 ulps of zero
};
constexpr Expected expectations[] = {
    {"quaternion-tangent", 23, 19, 83},
    {"pythagorean-tangent", 23, 19, 85},
    {"tangent-third", 23, 20, 88},
    {"pell", 19, 0, 76},
    {"unimodular", 22, 20, 87},
    {"origin-on-surface", 21, 27, 78},
    {"b-zero", 21, 12, 83},
    {"a-extreme", 22, 21, 77},
    {"far-small", 19, 27, 63},
    {"edge-corner", 22, 26, 70},
    {"fan", 22, 10, 52},
    {"aimed", 22, 20, 71},
    {"origin-zero", 22, 18, 44},
    {"coplanar", 23, 31, 90},
    {"sliver", 22, 27, 84},
    {"degenerate", 22, 24, 91},
    {"rounding", 21, 12, 44},
    {"near-tie", 21, 0, 25},
    {"interval", 45, 35, 81},
    {"range", 20, 18, 59},
    {"lattice", 0, 38, 69},
    {"implicit", 23, 10, 62},
    {"invalid", 92, 3, 8},
    {"random", 0, 0, 0},
};

struct Tally {
  int labelled = 0, exact = 0, near = 0, invalid = 0;
  std::vector<std::uint64_t> broken;  ///< indices of cases whose promise the oracle denies
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
    if (label.sphere || label.triangle || label.side || label.status) ++sum.labelled;
    if (!keeps_promise(label, answer)) sum.broken.push_back(index);
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
void check_shares(const Expected& expected) {
  constexpr int count = 4000;
  const Family* family = find_family(expected.family);
  REQUIRE(family != nullptr);
  const Tally sum = tally<T>(*family, count);
  INFO(expected.family << ", " << sizeof(T) * 8 << " bits: " << sum.labelled << " promised, " << sum.exact << " exact, "
                       << sum.near << " near, " << sum.invalid << " invalid of " << count);
  CAPTURE(sum.broken);
  CHECK(sum.broken.empty());
  CHECK(sum.labelled * 100 >= expected.labelled * count);
  CHECK(sum.exact * 100 >= expected.exact * count);
  CHECK(sum.near * 100 >= expected.near * count);
  if (expected.family != "invalid") CHECK(sum.invalid == 0);
  if (expected.family == "random") CHECK(sum.near * 100 < count);
}

TEST_CASE("Every promise holds, and enough cases lie on a boundary") {
  CHECK(std::size(expectations) == families().size());
  for (const Expected& expected : expectations) {
    check_shares<float>(expected);
    check_shares<double>(expected);
  }
}

template <Real T>
void check_determinism(const Family& family) {
  INFO(family.name << ", " << sizeof(T) * 8 << " bits");
  constexpr int count = 1000;
  std::vector<std::uint64_t> first, second;
  std::unordered_set<std::uint64_t> different;
  for (std::uint64_t index = 0; index < count; ++index) first.push_back(hash_of(make<T>(family, seed, index).input));
  for (std::uint64_t index = count; index-- > 0;) second.push_back(hash_of(make<T>(family, seed, index).input));
  std::reverse(second.begin(), second.end());
  CHECK(first == second);

  int changed = 0;
  for (std::uint64_t index = 0; index < count; ++index) {
    different.insert(first[index]);
    if (hash_of(make<T>(family, seed + 1, index).input) != first[index]) ++changed;
  }
  CHECK(changed > count * 9 / 10);
  CHECK(different.size() > count * 9 / 10);
}

TEST_CASE("A case is a function of seed and index alone") {
  for (const Family& family : families()) {
    check_determinism<float>(family);
    check_determinism<double>(family);
  }
}

TEST_CASE("Families are found by their names, which differ") {
  std::unordered_set<std::string_view> names;
  for (const Family& family : families()) {
    CHECK(find_family(family.name) == &family);
    CHECK(names.insert(family.name).second);
    CHECK_FALSE(family.attacks.empty());
    for (const std::string_view text : {family.note.bug, family.note.effect, family.note.published}) {
      CHECK_FALSE(text.empty());
      CHECK(text.find_first_of("|\n") == std::string_view::npos);
    }
  }
  CHECK(find_family("no-such-family") == nullptr);
}

template <Real T>
void check_kinds() {
  std::array<int, 4> spheres{};
  std::array<int, 11> triangles{};
  int finite_ranges = 0, negative_starts = 0;
  for (const Family& family : families()) {
    for (std::uint64_t index = 0; index < 2000; ++index) {
      const LabelledCase<T> made = make<T>(family, seed, index);
      const Answer<T> answer = oracle_answer(made.input);
      if (const auto* sphere = std::get_if<SphereHit<T>>(&answer)) ++spheres[static_cast<std::size_t>(sphere->kind)];
      if (const auto* triangle = std::get_if<TriangleHit<T>>(&answer)) ++triangles[static_cast<std::size_t>(triangle->kind)];
      if (const auto* query = std::get_if<RaySphere<T>>(&made.input)) {
        if (std::isfinite(query->ray.t_max)) ++finite_ranges;
        if (query->ray.t_min < T(0)) ++negative_starts;
      }
    }
  }
  for (const int count : spheres) CHECK(count > 300);
  for (const int count : triangles) CHECK(count > 300);
  CHECK(finite_ranges > 300);
  CHECK(negative_starts > 300);
}

TEST_CASE("Every kind comes up, and so do ranges") {
  check_kinds<float>();
  check_kinds<double>();
}

/// Whether a value lies within 2^-10 ulps of the middle between two numbers of the format, or on it.
template <Real T>
bool is_near_tie(const oracle::Exact& value, T rounded) {
  if (!std::isfinite(rounded) || rounded == T(0)) return false;
  return oracle::error_in_ulps(value, rounded) > 0.5 - 0x1p-10;
}

template <Real T>
void check_near_ties() {
  const Family& family = *find_family("rounding");
  constexpr int count = 4000;
  int ties = 0, subnormal = 0, overflowing = 0;
  for (std::uint64_t index = 0; index < count; ++index) {
    const LabelledCase<T> made = make<T>(family, seed, index);
    bool is_tie = false;
    T t{};
    if (const auto* query = std::get_if<RaySphere<T>>(&made.input)) {
      const auto truth = oracle::gmp_oracle().truth(query->ray, query->sphere);
      for (int i = 0; i < truth.hit.count(); ++i) {
        t = truth.hit.t[i];
        is_tie |= is_near_tie(truth.t[i], t);
      }
    } else if (const auto* other = std::get_if<RayTriangle<T>>(&made.input)) {
      const auto truth = oracle::gmp_oracle().truth(other->ray, other->triangle);
      t = truth.hit.t;
      if (truth.hit.kind != TriangleKind::miss && !truth.hit.is_interval()) {
        is_tie = is_near_tie(truth.t, t) || is_near_tie(truth.u, truth.hit.u) || is_near_tie(truth.v, truth.hit.v);
      }
    }
    if (is_tie) ++ties;
    if (t != T(0) && std::abs(t) < std::numeric_limits<T>::min()) ++subnormal;
    if (std::isinf(t)) ++overflowing;
  }
  INFO(ties << " ties, " << subnormal << " subnormal, " << overflowing << " infinite of " << count);
  CHECK(ties * 100 > 10 * count);
  CHECK(subnormal * 100 > 5 * count);
  CHECK(overflowing * 100 > 1 * count);
}

TEST_CASE("Family rounding has ties and near-ties, subnormal values and overflow") {
  check_near_ties<float>();
  check_near_ties<double>();
}

TEST_CASE("Family fan has one ray for eight triangles, and a hit of it is no crack") {
  const Family& family = *find_family("fan");
  int hubs = 0, edges = 0, faces = 0;
  for (std::uint64_t group = 0; group < 1600; ++group) {
    int hits = 0;
    Ray<double> shared;
    bool is_promised = true, is_hub = false, is_edge = false;
    for (std::uint64_t k = 0; k < 8; ++k) {
      const LabelledCase<double> made = make<double>(family, seed, 8 * group + k);
      const auto& query = std::get<RayTriangle<double>>(made.input);
      if (k == 0) shared = query.ray;
      REQUIRE(query.ray == shared);
      const TriangleKind kind = oracle::gmp_oracle().answer(query.ray, query.triangle).kind;
      if (kind != TriangleKind::miss) ++hits;
      is_promised = is_promised && made.label.triangle.has_value();
      is_hub |= made.label.triangle && *made.label.triangle >= TriangleKind::vertex_a;
      is_edge |=
          made.label.triangle && *made.label.triangle >= TriangleKind::edge_ab && *made.label.triangle <= TriangleKind::edge_ca;
    }
    CHECK(is_promised <= (group % 4 == 0));
    if (!is_promised || hits == 0) continue;
    if (is_hub) {
      ++hubs;
      CHECK((hits == 8 || hits == 2));  // the hub, or a corner of the rim
    } else if (is_edge) {
      ++edges;
      CHECK((hits == 2 || hits == 1));  // a spoke, or a piece of the rim
    } else {
      ++faces;
      CHECK(hits == 1);
    }
  }
  CHECK(hubs > 10);
  CHECK(edges > 10);
  CHECK(faces > 10);
}

TEST_CASE("Family lattice leaves no sphere of its list out") {
  const Family& family = *find_family("lattice");
  constexpr std::uint64_t spheres = 27 * 26 * 27 * 4;
  std::unordered_set<std::uint64_t> seen;
  for (std::uint64_t round = 0; round < spheres; ++round) {
    const LabelledCase<float> made = make<float>(family, seed, 8 * round + 7);
    REQUIRE(std::holds_alternative<RaySphere<float>>(made.input));
    seen.insert(hash_of(made.input));
  }
  CHECK(seen.size() == spheres);
}

}  // namespace
}  // namespace graze::fuzz
