// origin-zero. The ray starts at zero and its direction is bitwise a corner (t = 1), the sum of two (an edge, t = 1/2), of
// three (the face, t = 1/3, u = v = 1/3), minus one of them (behind), or a sphere's center. Subtractions are exact here and
// each corner has a full mantissa: what is left to fail are the products.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

TriangleDraft corners_at_zero(Random& random, int digits) {
  const int bits = choose_bits(random, 2, digits - 2);
  TriangleDraft draft;
  for (IntVec& corner : draft.corner) corner = choose_vector(random, bits);
  const auto& [a, b, c] = draft.corner;
  Mark mark{1, 1};
  TriangleKind kind = TriangleKind::vertex_a;
  switch (random.below(6)) {
    case 0:
    case 1:
      draft.direction = a;
      break;
    case 2:
    case 3:
      draft.direction = a + b;
      kind = TriangleKind::edge_ab;
      mark.den = 2;
      break;
    case 4:
      draft.direction = a + b + c;
      kind = TriangleKind::face;
      mark.den = 3;
      break;
    default:
      draft.direction = -a;
      mark.num = -1;
      break;
  }
  if (is_zero(draft.direction))
    draft.direction = {1, 0, 0};
  else if (surely_independent(a, b, c))
    draft.promise = {kind, one_mark(mark)};
  return draft;
}

}  // namespace

SphereDraft rational_roots_draft(Random& random, int digits) {
  SphereDraft draft;
  if (random.one_in(2)) {
    // |c| = h is an integer: the roots are 1 - r / h and 1 + r / h.
    const int quaternion_bits = choose_bits(random, 1, (digits - 4) / 2);
    const Frame frame = choose_frame(random, quaternion_bits);
    draft.center = frame.r1;
    draft.radius = random.one_in(4) ? frame.length : choose_natural(random, bit_length(frame.length));
    const Mark first = make_mark(frame.length - draft.radius, frame.length);
    const Mark second = make_mark(frame.length + draft.radius, frame.length);
    draft.promise = {SphereKind::secant, two_marks(first, second)};
  } else {
    const int bits = choose_bits(random, 2, digits - 2);
    draft.center = choose_vector(random, bits);
    draft.radius = choose_natural(random, bits);
    draft.promise = forward_promise(SphereKind::secant);  // the second root lies beyond the center
  }
  draft.direction = draft.center;
  if (draft.radius == 0 || random.one_in(6)) {
    draft.radius = 0;
    draft.promise = {SphereKind::tangent, one_mark(Mark{1, 1})};
  }
  return draft;
}

namespace {
struct OriginZero {
  static constexpr std::string_view name = "origin-zero";
  static constexpr std::string_view attacks = "direction bitwise a corner, a sum of corners or a center, from zero";
  static constexpr Note note{"products of full mantissas with no subtraction to blame",
                             "an edge or a corner is missed although no coordinate was rounded",
                             "mrdoob/three.js issue 11449: a single ray passes through a mesh"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.translate = false;
    plan.one_scale = true;
    return finish<T>(any_shape<T>(random, index), random, index, plan);
  }

 private:
  template <Real T>
  static Draft any_shape(Random& random, std::uint64_t index) {
    if (is_triangle_index(index)) return corners_at_zero(random, digits<T>);
    return rational_roots_draft(random, digits<T>);
  }
};
}  // namespace

Family origin_zero_family() {
  return family_of<OriginZero>();
}

}  // namespace graze::fuzz::construct
