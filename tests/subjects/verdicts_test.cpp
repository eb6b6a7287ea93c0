// Verdicts: each disagreement by its rank, each declared deviation allowed for and noted, and tallies that merge in any order.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz/certify/check.hpp"
#include "fuzz/in_float_mode.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

using Sphere3 = SphereHit<double>;
using Triangle3 = TriangleHit<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// From (0,0,0) along x through the sphere about (5,0,0): secant 4 6.
const Case<double> secant = RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
const Sphere3 secant_answer{Status::ok, SphereKind::secant, Root::both, OriginSide::outside, {4, 6}};
const Case<double> tangent = RaySphere<double>{{{0, 1, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
const Sphere3 tangent_answer{Status::ok, SphereKind::tangent, Root::both, OriginSide::outside, {5, 0}};
const Case<double> passing = RaySphere<double>{{{0, 2, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
const Sphere3 passing_answer{Status::ok, SphereKind::miss, Root::none, OriginSide::outside, {}};
const Case<double> directionless = RaySphere<double>{{{0, 2, 0}, {0, 0, 0}}, {{5, 0, 0}, 1}};

Case<double> down(double x, double y) {
  return RayTriangle<double>{{{x, y, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
}
const Case<double> face = down(0.25, 0.5);
const Triangle3 face_answer{Status::ok, TriangleKind::face, Facing::front, 1, 1, 0.25, 0.5};
const Case<double> edge = down(0.25, 0);
const Triangle3 edge_answer{Status::ok, TriangleKind::edge_ab, Facing::front, 1, 1, 0.25, 0};
const Case<double> coplanar = RayTriangle<double>{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}}};
const Triangle3 coplanar_answer{Status::ok, TriangleKind::coplanar, Facing::none, 1, 2, 0, 0};
const Case<double> degenerate = RayTriangle<double>{{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
const Triangle3 degenerate_answer{Status::ok, TriangleKind::degenerate, Facing::none, 1, 3, 0, 0};

Comparison judge(const Case<double>& input, const Answer<double>& answer, const Deviations& declared = {}) {
  return compare(input, answer, answer_of(oracle::gmp_oracle(), input), oracle::gmp_oracle(), declared);
}

Disagreement verdict(const Case<double>& input, const Answer<double>& answer, const Deviations& declared = {}) {
  return judge(input, answer, declared).disagreement;
}

/// The hit with a change made to it.
template <class Hit, class Change>
Hit but(Hit hit, Change change) {
  change(hit);
  return hit;
}

/// The deviation turns the disagreement into none, and is noted; no other one does.
void check_allowed(const Case<double>& input, const Answer<double>& answer, Deviation deviation, Disagreement without) {
  CAPTURE(std::string(name_of(deviation)));
  CHECK(verdict(input, answer) == without);
  CHECK(judge(input, answer).allowed.empty());
  for (std::size_t i = 0; i < deviation_count; ++i) {
    const auto d = static_cast<Deviation>(i);
    const Comparison with = judge(input, answer, {{d}});
    CHECK((with.disagreement == Disagreement::none) == (d == deviation));
    if (d == deviation) CHECK(with.allowed == DeviationSet{deviation});
  }
}

}  // namespace

TEST_CASE("right answers agree") {
  CHECK(verdict(secant, secant_answer) == Disagreement::none);
  CHECK(verdict(tangent, tangent_answer) == Disagreement::none);
  CHECK(verdict(passing, passing_answer) == Disagreement::none);
  CHECK(verdict(face, face_answer) == Disagreement::none);
  CHECK(verdict(edge, edge_answer) == Disagreement::none);
  CHECK(verdict(coplanar, coplanar_answer) == Disagreement::none);
  CHECK(verdict(degenerate, degenerate_answer) == Disagreement::none);
  CHECK(judge(face, face_answer).has_numbers);
  CHECK(!judge(passing, passing_answer).has_numbers);
}

TEST_CASE("disagreements of spheres") {
  CHECK(verdict(secant, passing_answer) == Disagreement::lost_hit);
  CHECK(verdict(passing, secant_answer) == Disagreement::false_hit);
  CHECK(verdict(tangent, but(tangent_answer, [](auto& h) { h.kind = SphereKind::secant; })) == Disagreement::wrong_kind);
  CHECK(verdict(secant, tangent_answer) == Disagreement::wrong_kind);
  CHECK(verdict(secant, but(secant_answer, [](auto& h) { std::swap(h.t[0], h.t[1]); })) == Disagreement::wrong_order);
  CHECK(verdict(secant, but(secant_answer, [](auto& h) { h.origin = OriginSide::on; })) == Disagreement::wrong_detail);
  CHECK(verdict(secant, but(secant_answer, [](auto& h) { h.root = Root::first; })) == Disagreement::wrong_kind);
  CHECK(verdict(secant, but(secant_answer, [](auto& h) { h.t[1] = 6.5; })) == Disagreement::misrounded);
  CHECK(verdict(directionless, passing_answer) == Disagreement::invalid_handling);
  CHECK(verdict(directionless, secant_answer) == Disagreement::invalid_handling);
  CHECK(verdict(directionless, Sphere3{Status::non_finite, SphereKind::invalid}) == Disagreement::invalid_handling);
  CHECK(verdict(directionless, Sphere3{Status::zero_direction, SphereKind::invalid}) == Disagreement::none);
  CHECK(verdict(secant, Sphere3{Status::zero_direction, SphereKind::invalid}) == Disagreement::lost_hit);
  CHECK(verdict(passing, Sphere3{Status::zero_direction, SphereKind::invalid}) == Disagreement::wrong_kind);
  CHECK(verdict(secant, face_answer) == Disagreement::wrong_kind);
  const Comparison infinite = judge(secant, but(secant_answer, [](auto& h) { h.t[0] = not_a_number; }));
  CHECK(infinite.disagreement == Disagreement::misrounded);
  CHECK(infinite.error_ulps == infinity);
}

TEST_CASE("which root a lone value is") {
  const Case<double> from_inside = RaySphere<double>{{{5, 0, 0}, {1, 0, 0}}, {{5, 0, 0}, 1}};
  const Sphere3 right{Status::ok, SphereKind::secant, Root::second, OriginSide::inside, {1, 0}};
  CHECK(verdict(from_inside, right) == Disagreement::none);
  check_allowed(from_inside, but(right, [](auto& h) { h.root = Root::first; }), Deviation::no_root, Disagreement::wrong_detail);
  // A root behind the origin is one too many, whatever is declared.
  const Sphere3 both{Status::ok, SphereKind::secant, Root::both, OriginSide::inside, {-1, 1}};
  CHECK(verdict(from_inside, both) == Disagreement::wrong_kind);
  CHECK(verdict(from_inside, both, {{Deviation::no_root, Deviation::nearest_root}}) == Disagreement::wrong_kind);
}

TEST_CASE("disagreements of triangles") {
  CHECK(verdict(face, Triangle3{}) == Disagreement::lost_hit);
  CHECK(verdict(down(2, 2), face_answer) == Disagreement::false_hit);
  CHECK(verdict(edge, but(edge_answer, [](auto& h) { h.kind = TriangleKind::edge_bc; })) == Disagreement::wrong_kind);
  CHECK(verdict(edge, but(edge_answer, [](auto& h) { h.kind = TriangleKind::vertex_a; })) == Disagreement::wrong_kind);
  CHECK(verdict(face, but(face_answer, [](auto& h) { h.facing = Facing::back; })) == Disagreement::wrong_detail);
  CHECK(verdict(face, but(face_answer, [](auto& h) { h.u = 0.3; })) == Disagreement::misrounded);
  CHECK(verdict(face, but(face_answer, [](auto& h) { h.v = not_a_number; })) == Disagreement::misrounded);
  CHECK(verdict(edge, but(edge_answer, [](auto& h) { h.v = -0.0; })) == Disagreement::misrounded);
  CHECK(verdict(coplanar, but(coplanar_answer, [](auto& h) { h.t_end = 3; })) == Disagreement::misrounded);
  CHECK(verdict(down(2, 2), but(Triangle3{}, [](auto& h) { h.facing = Facing::back; })) == Disagreement::wrong_detail);
}

TEST_CASE("declared deviations are allowed for and noted") {
  const Triangle3 miss{};
  check_allowed(coplanar, miss, Deviation::coplanar_is_miss, Disagreement::lost_hit);
  check_allowed(degenerate, miss, Deviation::degenerate_is_miss, Disagreement::lost_hit);
  const auto to_back = [](auto& h) { h.facing = Facing::back; };
  check_allowed(face, but(face_answer, to_back), Deviation::no_facing, Disagreement::wrong_detail);
  check_allowed(secant, but(secant_answer, [](auto& h) { h.origin = OriginSide::on; }), Deviation::no_origin,
                Disagreement::wrong_detail);
  check_allowed(secant, but(secant_answer, [](auto& h) { h.root = Root::first; }), Deviation::nearest_root,
                Disagreement::wrong_kind);
  check_allowed(face, but(face_answer, [](auto& h) { h.u = h.v = 0; }), Deviation::no_coordinates, Disagreement::misrounded);
  check_allowed(directionless, passing_answer, Deviation::invalid_unhandled, Disagreement::invalid_handling);
  const auto as_face = but(edge_answer, [](auto& h) { h.kind = TriangleKind::face; });
  CHECK(verdict(edge, as_face) == Disagreement::wrong_kind);
  CHECK(verdict(edge, as_face, {{Deviation::edges_are_faces}}) == Disagreement::none);
  CHECK(verdict(edge, as_face, {{Deviation::hit_or_miss}}) == Disagreement::none);
  const auto as_secant = but(tangent_answer, [](auto& h) {
    h.kind = SphereKind::secant;
    h.t[1] = 5;
  });
  CHECK(verdict(tangent, as_secant) == Disagreement::wrong_kind);
  CHECK(verdict(tangent, as_secant, {{Deviation::tangents_are_secants}}) == Disagreement::none);
  CHECK(verdict(tangent, as_secant, {{Deviation::hit_or_miss}}) == Disagreement::none);
}

TEST_CASE("a declared deviation excuses no more than it says") {
  CHECK(verdict(face, Triangle3{}, {{Deviation::coplanar_is_miss, Deviation::degenerate_is_miss}}) == Disagreement::lost_hit);
  const auto as_face = but(coplanar_answer, [](auto& h) { h.kind = TriangleKind::face; });
  CHECK(verdict(coplanar, as_face, {{Deviation::coplanar_is_miss, Deviation::edges_are_faces}}) == Disagreement::wrong_kind);
  const auto as_edge = but(face_answer, [](auto& h) { h.kind = TriangleKind::edge_ab; });
  CHECK(verdict(face, as_edge, {{Deviation::edges_are_faces}}) == Disagreement::wrong_kind);
  CHECK(verdict(secant, tangent_answer, {{Deviation::tangents_are_secants}}) == Disagreement::wrong_kind);
  CHECK(verdict(face, but(face_answer, [](auto& h) { h.t = 2; }), {{Deviation::no_coordinates}}) == Disagreement::misrounded);
  CHECK(verdict(passing, Sphere3{Status::zero_direction, SphereKind::invalid}, {{Deviation::invalid_unhandled}}) ==
        Disagreement::wrong_kind);
  const auto far_off = but(tangent_answer, [](auto& h) {
    h.kind = SphereKind::secant;
    h.t[1] = 6;
  });
  CHECK(verdict(tangent, far_off, {{Deviation::hit_or_miss}}) == Disagreement::misrounded);
}

TEST_CASE("declared ulps are the limit, to the ulp") {
  const double above = std::nextafter(1.0, 2.0), two_above = std::nextafter(above, 2.0);
  const auto t_at = [](double t) { return but(face_answer, [t](auto& h) { h.t = t; }); };
  CHECK(verdict(face, t_at(above), {{}, 1, 0.5}) == Disagreement::none);
  CHECK(judge(face, t_at(above), {{}, 1, 0.5}).allowed == DeviationSet{Deviation::inexact_numbers});
  CHECK(judge(face, t_at(above), {{}, 1, 0.5}).error_ulps == 1);
  CHECK(verdict(face, t_at(two_above), {{}, 1, 0.5}) == Disagreement::misrounded);
  CHECK(verdict(face, t_at(two_above), {{}, 2, 0.5}) == Disagreement::none);
  CHECK(verdict(face, t_at(above), {{}, 0.5, 8}) == Disagreement::misrounded);
  const auto u_at = [](double u) { return but(face_answer, [u](auto& h) { h.u = u; }); };
  CHECK(verdict(face, u_at(std::nextafter(0.25, 1)), {{}, 8, 0.5}) == Disagreement::misrounded);
  CHECK(verdict(face, u_at(std::nextafter(0.25, 1)), {{}, 0.5, 1}) == Disagreement::none);
  CHECK(verdict(edge, but(edge_answer, [](auto& h) { h.v = -0.0; }), {{}, 0.5, 1}) == Disagreement::none);
  CHECK(verdict(face, t_at(not_a_number), {{}, infinity, infinity}) == Disagreement::none);
  CHECK(verdict(face, t_at(not_a_number), {{}, 1e300, 1e300}) == Disagreement::misrounded);
}

TEST_CASE("ranks are those of the contract's reader") {
  CHECK(Disagreement::lost_hit > Disagreement::false_hit);
  CHECK(Disagreement::false_hit > Disagreement::wrong_kind);
  CHECK(Disagreement::wrong_kind > Disagreement::wrong_order);
  CHECK(Disagreement::wrong_order > Disagreement::misrounded);
  CHECK(Disagreement::misrounded > Disagreement::invalid_handling);
  // Of several faults in one answer the worst is told.
  const auto swapped_and_off = but(secant_answer, [](auto& h) {
    h.t[0] = 6.5;
    h.t[1] = 4;
    h.origin = OriginSide::inside;
  });
  CHECK(verdict(secant, swapped_and_off) == Disagreement::wrong_order);
  CHECK(judge(secant, swapped_and_off).error_ulps > 1);
}

TEST_CASE("errors are counted by their size") {
  CHECK(error_bin(0) == 0);
  CHECK(error_bin(0.5) == 1);
  CHECK(error_bin(1) == 2);
  CHECK(error_bin(1.99) == 2);
  CHECK(error_bin(2) == 3);
  CHECK(error_bin(0x1p62) == 64);
  CHECK(error_bin(0x1p63) == 65);
  CHECK(error_bin(1e300) == 65);
  CHECK(error_bin(infinity) == 66);
  CHECK(error_bin(not_a_number) == 66);
}

namespace {

/// A subject that answers by turns rightly, wrongly, with a deviation, not at all.
Tally part(std::uint64_t from, std::uint64_t to) {
  Tally tally;
  const Triangle3 late = but(face_answer, [](auto& h) { h.t = 1.5; });
  class Nobody final : public Subject {
    [[nodiscard]] std::string_view name() const override { return "nobody"; }
    [[nodiscard]] std::string_view about() const override { return "declares that coplanar is a miss"; }
    [[nodiscard]] const Deviations& deviations() const override { return declared_; }
    [[nodiscard]] Reply<float> answer(const Case<float>&) const override { return {}; }
    [[nodiscard]] Reply<double> answer(const Case<double>&) const override { return {}; }
    Deviations declared_{{Deviation::coplanar_is_miss}};
  } nobody;
  const Judges judges{{&nobody}, oracle::gmp_oracle(), oracle::gmp_oracle(), 0};
  const auto check_one = [&](const Case<double>& input, Reply<double> reply, std::uint64_t index) {
    check(judges, input, Replies<double>{{std::move(reply)}}, 0, index, tally);
  };
  for (std::uint64_t i = from; i < to; ++i) {
    switch (i % 6) {
      case 0:
        check_one(face, Reply<double>(Answer<double>(face_answer)), i);
        break;
      case 1:
        check_one(face, Reply<double>(Answer<double>(late)), i);
        break;
      case 2:
        check_one(coplanar, Reply<double>(Answer<double>(Triangle3{})), i);
        break;
      case 3:
        check_one(secant, Reply<double>::failed("crashed"), i / 12);  // an index that several share
        break;
      case 4:
        check_one(face, Reply<double>::failed("crashed"), i / 12);
        break;
      default:
        check_one(secant, Reply<double>(), i);
    }
  }
  return tally;
}

/// Everything in the tally, as text.
std::string text(const Tally& t) {
  std::string s = std::to_string(t.answers) + " " + std::to_string(t.skipped) + " " + std::to_string(t.misrounded) + " " +
                  std::to_string(t.worst_ulps) + " " + std::to_string(t.oracles_compared);
  const auto list = [&](const auto& counts) {
    for (const auto n : counts) s += " " + std::to_string(n);
  };
  list(t.by_disagreement);
  list(t.by_deviation);
  list(t.by_error);
  for (const Offender& o : t.offenders) {
    s += "\n" + std::to_string(o.index) + " " + o.input + " " + o.answer + " " + o.truth;
  }
  return s;
}

}  // namespace

TEST_CASE("a tally counts answers, deviations, failures and what was not offered") {
  const Tally t = part(0, 60);
  CHECK(t.answers == 50);
  CHECK(t.skipped == 10);
  CHECK(t.count(Disagreement::none) == 20);
  CHECK(t.count(Disagreement::misrounded) == 10);
  CHECK(t.count(Disagreement::failed) == 20);
  CHECK(t.count(Deviation::coplanar_is_miss) == 10);
  CHECK(t.by_error[0] == 10);
  CHECK(t.by_error[53] == 10);  // 2^51 ulps
  CHECK(t.wrong_kinds() == 0);
  CHECK(!t.is_clean());
  REQUIRE(t.offenders.size() == Tally::kept_offenders);
  CHECK(t.offenders[0].answer == "crashed");
  Tally clean = part(0, 1);
  CHECK(clean.is_clean());
  clean.merge(part(2, 3));
  CHECK(clean.is_clean());
  clean.merge(part(1, 2));
  CHECK(!clean.is_clean());
}

TEST_CASE("a case is told once, in the mode in which it fails worst") {
  const Subject& graze = *find_subject("graze");
  const InFloatMode upward(graze, FloatMode::upward), downward(graze, FloatMode::downward);
  const Judges judges{{&graze, &upward, &downward}, oracle::gmp_oracle(), oracle::gmp_oracle(), 0};
  const Triangle3 late = but(face_answer, [](auto& h) { h.t = 1.5; });
  const Reply<double> right(face_answer), off(late), lost(Triangle3{});
  Tally tally;
  check(judges, face, Replies<double>{{right}, {lost}, {lost}}, 0, 0, tally);
  check(judges, face, Replies<double>{{off}, {right}, {off}}, 0, 1, tally);
  check(judges, face, Replies<double>{{right}, {off}, {lost}}, 0, 2, tally);
  CHECK(tally.answers == 9);
  CHECK(tally.count(Disagreement::lost_hit) == 3);
  CHECK(tally.count(Disagreement::misrounded) == 3);
  REQUIRE(tally.offenders.size() == 3);
  const auto told = [&](std::size_t i, std::uint64_t index, FloatMode mode, Disagreement disagreement) {
    const Offender& o = tally.offenders[i];
    CHECK(o.index == index);
    CHECK(o.mode == mode);
    CHECK(o.comparison.disagreement == disagreement);
  };
  told(0, 0, FloatMode::upward, Disagreement::lost_hit);
  told(1, 2, FloatMode::downward, Disagreement::lost_hit);
  told(2, 1, FloatMode::nearest, Disagreement::misrounded);
}

TEST_CASE("tallies merge in any order and grouping") {
  const std::string whole = text(part(0, 60));
  std::vector<int> order{0, 1, 2, 3};
  const auto quarter = [](int i) { return part(static_cast<std::uint64_t>(15 * i), static_cast<std::uint64_t>(15 * i + 15)); };
  do {
    Tally one_by_one;
    for (const int i : order) one_by_one.merge(quarter(i));
    CHECK(text(one_by_one) == whole);
    Tally left = quarter(order[0]), right = quarter(order[2]);
    left.merge(quarter(order[1]));
    right.merge(quarter(order[3]));
    left.merge(right);
    CHECK(text(left) == whole);
  } while (std::next_permutation(order.begin(), order.end()));
}
