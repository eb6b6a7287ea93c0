// The fuzzer's own changes of cases: each does what it says.
#include "fuzz/case_mutator.hpp"

#include <cmath>
#include <set>

#include "fuzz/case_text.hpp"
#include "fuzz/families/coordinates.hpp"
#include "fuzz/family.hpp"
#include "fuzz/same_bits.hpp"
#include "oracle/oracle.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

constexpr int rounds = 400;

const Case<double> sphere_case = RaySphere<double>{{{1, 2, 3}, {2, -1, 4}}, {{5, 6, 7}, 3}};
const Case<double> triangle_case = RayTriangle<double>{{{1, 1, 5}, {1, 2, -1}}, {{0, 0, 0}, {4, 0, 2}, {1, 4, 8}}};
const Case<double> line_case = PointLine<double>{{3, 5}, {2, -7, 4}};
const Case<double> plane_case = PointPlane<double>{{3, 5, 7}, {2, -7, 4, 1}};
const Case<double> ball_case = PointSphere<double>{{1, 2, 3}, {{5, 6, 7}, 3}};

/// How often the change of the case is followed by what is asked of it.
template <class Holds>
int count(const Case<double>& input, Mutation mutation, Holds holds) {
  int sum = 0;
  for (std::uint64_t index = 0; index < rounds; ++index) {
    Random random(11, "count", index);
    Case<double> changed = input;
    REQUIRE(mutate(changed, mutation, random));
    CHECK(changed.index() == input.index());
    sum += holds(changed) ? 1 : 0;
  }
  return sum;
}

std::vector<double> numbers(Case<double> input) {
  const auto all = construct::coordinates(input);
  std::vector<double> list;
  for (std::size_t i = 0; i < all.count; ++i) list.push_back(*all.at[i]);
  return list;
}

/// The positions at which two cases differ.
std::vector<std::size_t> differences(const Case<double>& a, const Case<double>& b) {
  const auto of_a = numbers(a), of_b = numbers(b);
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (!same_bits(of_a[i], of_b[i])) list.push_back(i);
  }
  return list;
}

SphereHit<double> truth(const RaySphere<double>& query) {
  return oracle::gmp_oracle().answer(query.ray, query.sphere);
}
TriangleHit<double> truth(const RayTriangle<double>& query) {
  return oracle::gmp_oracle().answer(query.ray, query.triangle);
}
bool is_on(const Case<double>& input) {
  const oracle::Oracle& oracle = oracle::gmp_oracle();
  if (const auto* line = std::get_if<PointLine<double>>(&input)) {
    return oracle.side(line->point, line->line).sign == Sign::zero;
  }
  if (const auto* plane = std::get_if<PointPlane<double>>(&input)) {
    return oracle.side(plane->point, plane->plane).sign == Sign::zero;
  }
  const auto& ball = std::get<PointSphere<double>>(input);
  return oracle.side(ball.point, ball.sphere).sign == Sign::zero;
}

bool is_at_feature(TriangleKind kind) {
  return kind != TriangleKind::miss && kind != TriangleKind::face;
}

}  // namespace

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

TEST_CASE("a number is copied, negated, made small or moved by an ulp, and no other changes") {
  for (const Case<double>* input : {&sphere_case, &triangle_case, &line_case, &plane_case, &ball_case}) {
    const auto old = numbers(*input);
    const auto one_changes = [&](Mutation mutation, auto is_right) {
      return count(*input, mutation, [&](const Case<double>& changed) {
        const auto at = differences(*input, changed);
        REQUIRE(at.size() <= (mutation == Mutation::nudge ? 2 : 1));
        for (const std::size_t i : at) CHECK(is_right(numbers(changed)[i], old[i]));
        return !at.empty();
      });
    };
    CHECK(one_changes(Mutation::copy, [&](double now, double) { return std::find(old.begin(), old.end(), now) != old.end(); }) >
          rounds / 2);
    CHECK(one_changes(Mutation::negate, [](double now, double before) { return now == -before; }) == rounds);
    CHECK(one_changes(Mutation::simplify, [](double now, double) { return now >= -2 && now <= 4 && now == std::trunc(now); }) >
          rounds / 2);
    CHECK(one_changes(Mutation::nudge, [](double now, double before) {
            return before == 0 ? now != 0 : std::abs(now - before) <= std::abs(before) * 0x1p-51;
          }) > rounds / 2);
  }
}

TEST_CASE("scaling and permuting keep the sizes of numbers, up to a power of two") {
  for (const Case<double>* input : {&sphere_case, &triangle_case, &line_case, &plane_case, &ball_case}) {
    const auto significands = [](const Case<double>& any) {
      std::multiset<double> set;
      for (const double x : numbers(any)) {
        int exponent = 0;
        set.insert(std::abs(std::frexp(x, &exponent)));
      }
      return set;
    };
    const auto is_kept = [&](const Case<double>& changed) { return significands(changed) == significands(*input); };
    CHECK(count(*input, Mutation::scale, is_kept) == rounds);
    CHECK(count(*input, Mutation::permute, is_kept) == rounds);
    CHECK(count(*input, Mutation::permute, [&](const Case<double>& changed) { return !differences(*input, changed).empty(); }) >
          rounds / 2);
  }
}

TEST_CASE("permuting the axes keeps the exact answer, and the corners its kind of face") {
  const RaySphere<double> through{{{0, 0, 0}, {1, 2, 3}}, {{2, 4, 5}, 2}};
  const SphereHit<double> hit = truth(through);
  CHECK(count(through, Mutation::permute, [&](const Case<double>& changed) {
          const SphereHit<double> now = truth(std::get<RaySphere<double>>(changed));
          return now == hit || now.kind == SphereKind::miss;  // turned around
        }) == rounds);
  const RayTriangle<double> face{{{1, 1, 5}, {0, 0, -1}}, {{0, 0, 0}, {4, 0, 1}, {0, 4, 2}}};
  CHECK(count(face, Mutation::permute, [&](const Case<double>& changed) {
          const TriangleHit<double> now = truth(std::get<RayTriangle<double>>(changed));
          return now.kind == TriangleKind::face || now.kind == TriangleKind::miss;
        }) == rounds);
}

TEST_CASE("an aimed ray meets a feature, and a ray that starts at one does") {
  for (const Mutation mutation : {Mutation::aim, Mutation::start}) {
    CHECK(count(triangle_case, mutation, [](const Case<double>& changed) {
            return is_at_feature(truth(std::get<RayTriangle<double>>(changed)).kind);
          }) > rounds / 2);
    CHECK(count(sphere_case, mutation, [](const Case<double>& changed) {
            return truth(std::get<RaySphere<double>>(changed)).kind == SphereKind::secant;
          }) == rounds);
  }
  CHECK(count(sphere_case, Mutation::start, [](const Case<double>& changed) {
          return truth(std::get<RaySphere<double>>(changed)).origin == OriginSide::on;
        }) > rounds / 6);
}

TEST_CASE("a touched case of small integers is tangent, in the plane or on the surface") {
  CHECK(count(sphere_case, Mutation::touch, [](const Case<double>& changed) {
          const auto query = std::get<RaySphere<double>>(changed);
          const Ray<double> line{query.ray.origin, query.ray.direction, -1e300};
          return truth(RaySphere<double>{line, query.sphere}).kind == SphereKind::tangent;
        }) > rounds / 3);
  CHECK(count(triangle_case, Mutation::touch, [](const Case<double>& changed) {
          const auto query = std::get<RayTriangle<double>>(changed);
          if (query.ray.direction == Vec3<double>{}) return false;
          return truth(query).facing == Facing::none;
        }) > rounds * 3 / 4);
  CHECK(count(triangle_case, Mutation::touch, [](const Case<double>& changed) {
          const auto query = std::get<RayTriangle<double>>(changed);
          return truth(query).kind == TriangleKind::coplanar;
        }) > rounds / 5);
  for (const Case<double>* input : {&line_case, &plane_case}) CHECK(count(*input, Mutation::touch, is_on) == rounds);
  CHECK(count(ball_case, Mutation::touch, is_on) > rounds / 3);
}

TEST_CASE("a collapsed shape has no area or no extent") {
  CHECK(count(triangle_case, Mutation::collapse, [](const Case<double>& changed) {
          const auto& [ray, triangle] = std::get<RayTriangle<double>>(changed);
          // From corner a along the segment, which is met wherever it lies.
          const auto& [a, b, c] = triangle;
          const Ray<double> along{a, {b.x - a.x, b.y - a.y, b.z - a.z}};
          return truth(RayTriangle<double>{along, triangle}).kind == TriangleKind::degenerate;
        }) == rounds);
  for (const Case<double>* input : {&sphere_case, &ball_case}) {
    CHECK(count(*input, Mutation::collapse, [](const Case<double>& changed) { return numbers(changed).back() == 0; }) ==
          rounds);
  }
  for (const Case<double>* input : {&line_case, &plane_case}) {
    Random random(1, "none", 0);
    Case<double> changed = *input;
    CHECK_FALSE(mutate(changed, Mutation::collapse, random));
    CHECK_FALSE(mutate(changed, Mutation::aim, random));
    CHECK_FALSE(mutate(changed, Mutation::bound, random));
    CHECK(differences(*input, changed).empty());
  }
}

TEST_CASE("a bound is put where the ray hits") {
  const RayTriangle<float> query{{{1, 1, 5}, {0, 0, -1}}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  std::set<float> starts, ends;
  for (std::uint64_t index = 0; index < rounds; ++index) {
    Random random(9, "bound", index);
    Case<float> input = query;
    REQUIRE(mutate(input, Mutation::bound, random));
    starts.insert(std::get<RayTriangle<float>>(input).ray.t_min);
    ends.insert(std::get<RayTriangle<float>>(input).ray.t_max);
  }
  CHECK(starts == std::set<float>{0, 5});
  CHECK(ends == std::set<float>{5, INFINITY});
}
