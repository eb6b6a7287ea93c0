// fan. Eight triangles around one hub corner; the ray passes the hub, a shared edge, or the inside of one triangle. Cases 8g to
// 8g + 7 are the eight triangles of fan g under one ray and one scale, so whoever runs them together sees whether a ray slips
// through the cracks or hits twice: the hub is a corner of all eight, an edge point belongs to just two. The rim points lie in
// eight directions of a lattice plane at random distances, pushed up and down along the ray's direction, so that seen along the
// ray the fan is flat and every promise is known. In nudged fans (three of four) only the ray is nudged.
#include <algorithm>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

constexpr std::uint64_t fan_size = 8;

struct Fan {
  std::array<IntVec, fan_size> rim;  ///< the hub is 0
  IntVec origin, direction;
  Marks marks;
  Barycentric point;  ///< in the triangle `target`: hub, rim[target], rim[target + 1]
  std::uint64_t target = 0;
  bool is_flat = false;  ///< lattice vectors were dependent: no promise
};

Fan choose_fan(Random& random, int digits) {
  static constexpr int octants[fan_size][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const int part_bits = random.between(1, digits / 6);
  const int reach_bits = random.between(1, digits / 4);
  const int vector_bits = choose_bits(random, 1, digits - 6 - part_bits - reach_bits);
  const int along_bits = choose_bits(random, 1, digits - 3 - vector_bits);
  const IntVec g1 = choose_vector(random, vector_bits);
  const IntVec g2 = choose_vector(random, vector_bits);
  const IntVec d = choose_vector(random, vector_bits);

  Fan fan;
  fan.is_flat = !surely_independent(g1, g2, d);
  fan.point = choose_point(random, part_bits);
  if (fan.point.i < 0 || fan.point.j < 0 || fan.point.i + fan.point.j > fan.point.q) fan.point = {0, 0, fan.point.q};
  for (std::size_t k = 0; k < fan_size; ++k) {
    const Int out = 1 + choose_natural(random, reach_bits);
    const Int up = random.one_in(2) ? 0 : choose_integer(random, reach_bits);
    fan.rim[k] = fan.point.q * ((out * octants[k][0]) * g1 + (out * octants[k][1]) * g2 + up * d);
  }
  fan.target = random.below(fan_size);
  const IntVec& first = fan.rim[fan.target];
  const IntVec& second = fan.rim[(fan.target + 1) % fan_size];
  const IntVec hit = fan.point.i * (first / fan.point.q) + fan.point.j * (second / fan.point.q);
  const Int tau = choose_natural(random, along_bits);
  const Int alpha = choose_factor(random, digits - vector_bits);
  fan.origin = hit - tau * d;
  fan.direction = alpha * d;
  fan.marks = one_mark(make_mark(tau, alpha));
  return fan;
}

/// What the ray meets in triangle k; corners hub, rim[k], rim[k + 1].
TriangleKind kind_in(const Fan& fan, std::uint64_t k) {
  const TriangleKind kind = kind_at(fan.point);
  if (kind == TriangleKind::vertex_a || k == fan.target) return kind;
  const bool is_before = (k + 1) % fan_size == fan.target;  // shares rim[target], as its corner c
  const bool is_after = (fan.target + 1) % fan_size == k;   // shares rim[target + 1], as its corner b
  if (is_before && kind == TriangleKind::vertex_b) return TriangleKind::vertex_c;
  if (is_before && kind == TriangleKind::edge_ab) return TriangleKind::edge_ca;
  if (is_after && kind == TriangleKind::vertex_c) return TriangleKind::vertex_b;
  if (is_after && kind == TriangleKind::edge_ca) return TriangleKind::edge_ab;
  return TriangleKind::miss;
}

struct FanFamily {
  static constexpr std::string_view name = "fan";
  static constexpr std::string_view attacks = "one ray against all triangles around a corner: cracks and double hits";
  static constexpr Note note{"no rule for a corner that many triangles share",
                             "a closed mesh leaks at its corners; crossing parity is wrong",
                             "dimforge/parry issue 444: one-pixel holes in a closed mesh"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    const std::uint64_t group = index / fan_size;
    const std::uint64_t k = index % fan_size;
    Random shared = random.at(group);
    const Fan fan = choose_fan(shared, digits<T>);
    TriangleDraft draft;
    draft.origin = fan.origin;
    draft.direction = fan.direction;
    draft.corner = {IntVec{}, fan.rim[k], fan.rim[(k + 1) % fan_size]};
    draft.promise.marks = fan.marks;
    if (!fan.is_flat) draft.promise.kind = kind_in(fan, k);

    Plan plan;
    plan.is_pure = group % 4 == 0;
    plan.nudged = Nudged::ray;
    plan.shared_position_bits = bit_length(fan.origin);
    for (const IntVec& rim : fan.rim) plan.shared_position_bits = std::max(plan.shared_position_bits, bit_length(rim));
    return finish<T>(draft, shared, plan);
  }
};

}  // namespace

Family fan_family() {
  return family_of<FanFamily>();
}

}  // namespace graze::fuzz::construct
