// origin-on-surface. Spheres: c - e is the edge of an integer frame, so C = |c - e|^2 - r^2 is 0 exactly: t = 0 is a root, and
// B > 0, B = 0 (tangent at the origin) and B < 0 decide what else there is; B = +-g, the least there is, comes from Bezout.
// Half of the spheres have an r that is a unit off. Triangles: the origin is a corner, on an edge or inside, and t = 0.
// Secondary rays of every renderer start like this. The sign of C must not come from rounded squares, and a root that rounds to
// -0 is not a hit.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// A direction with d . l positive, negative, zero, or as near to zero as integers allow.
IntVec choose_direction(Random& random, const IntVec& l, int digits) {
  const IntVec unit = primitive(l);
  switch (random.below(4)) {
    case 0: {
      const int bits = choose_bits(random, 1, digits - bit_length(unit) - 1);
      return choose_orthogonal(random, unit, bits);
    }
    case 1:
      if (2 * bit_length(unit) < digits) return random.sign() * bezout_vector(unit);
      [[fallthrough]];
    default: {
      const int bits = choose_bits(random, 1, digits);
      return choose_vector(random, bits);
    }
  }
}

TriangleDraft origin_on_triangle(Random& random, int digits) {
  const int part_bits = random.between(1, digits / 3);
  const int edge_bits = choose_bits(random, 1, digits - 3 - part_bits);
  const int direction_bits = choose_bits(random, 1, digits - 1);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = choose_vector(random, edge_bits);
  aim.point = choose_point(random, part_bits);
  aim.d = choose_vector(random, direction_bits);
  aim.tau = 0;
  return aimed_triangle(aim);
}

}  // namespace

SphereDraft sphere_through_origin_draft(Random& random, int digits) {
  const int quaternion_bits = choose_bits(random, 1, (digits - 4) / 2);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int factor_bits = choose_bits(random, 1, digits - 1 - bit_length(frame.length));
  const Int s = choose_nonzero(random, factor_bits);
  SphereDraft draft;
  draft.center = s * frame.r1;
  draft.radius = magnitude(s) * frame.length;
  draft.direction = choose_direction(random, draft.center, digits);
  const Int b = dot(draft.direction, draft.center);
  const Int a = dot(draft.direction, draft.direction);
  if (b == 0) {
    draft.promise = {SphereKind::tangent, one_mark(Mark{0, 1})};
  } else {
    draft.promise = forward_promise(SphereKind::secant);  // t = 0 is one of the roots
    if (bit_length(a) <= 70) draft.promise = {SphereKind::secant, two_marks(Mark{0, 1}, make_mark(2 * b, a))};
  }
  return draft;
}

namespace {
struct OriginOnSurface {
  static constexpr std::string_view name = "origin-on-surface";
  static constexpr std::string_view attacks = "C exactly 0 or a unit off; t = 0 on spheres and triangles";
  static constexpr Note note{"C = 0 taken for inside or outside by rounding",
                             "a secondary ray meets the surface that it starts from, or leaks through it",
                             "athas/raytracers issue 34: black dots where the hit comes out inside the sphere"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    if (is_triangle_index(index)) return finish<T>(origin_on_triangle(random, digits<T>), random, index);
    SphereDraft draft = sphere_through_origin_draft(random, digits<T>);
    if (random.one_in(2)) {
      const bool larger = draft.radius == 0 || random.one_in(2);
      draft.radius += larger ? 1 : -1;
      draft.promise = {};
      const Int b = dot(draft.direction, draft.center);
      if (larger) draft.promise = forward_promise(SphereKind::secant);  // the origin is inside
      if (!larger && b <= 0) draft.promise = forward_promise(SphereKind::miss);
    }
    return finish<T>(draft, random, index);
  }
};
}  // namespace

Family origin_on_surface_family() {
  return family_of<OriginOnSurface>();
}

}  // namespace graze::fuzz::construct
