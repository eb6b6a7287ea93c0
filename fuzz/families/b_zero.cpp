// b-zero. d is orthogonal to c - e, so the origin is the line's closest point and B = 0: roots are +-sqrt(-C / A). r is the
// integer root of |c - e|^2 or the next number (C the least there is of either sign), exactly it (a frame's length; tangent at
// t = 0), or any other. The stable quadratic with a sign of 0 for B divides zero by zero or loses a root here.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

SphereDraft b_zero_draft(Random& random, int digits) {
  SphereDraft draft;
  if (random.one_in(3)) {
    const int quaternion_bits = choose_bits(random, 1, (digits - 5) / 2);
    const Frame frame = choose_frame(random, quaternion_bits);
    draft.center = frame.r1;
    draft.radius = frame.length;
  } else {
    const int bits = choose_bits(random, 1, digits - 2);
    draft.center = choose_vector(random, bits);
    const Int root = integer_sqrt(dot(draft.center, draft.center));
    switch (random.below(4)) {
      case 0:
        draft.radius = root;
        break;
      case 1:
        draft.radius = root + 1;
        break;
      case 2:
        draft.radius = root + choose_natural(random, bits);
        break;
      default:
        draft.radius = choose_natural(random, bits);
        break;
    }
  }

  if (const int room = digits - 1 - bit_length(draft.center); room >= 1) {
    const int bits = choose_bits(random, 1, room);
    draft.direction = choose_orthogonal(random, draft.center, bits);
  } else {
    const IntVec& l = draft.center;
    draft.direction = l.x == 0 && l.y == 0 ? IntVec{1, 0, 0} : primitive(IntVec{-l.y, l.x, 0});
  }
  draft.direction = choose_factor(random, digits - bit_length(draft.direction)) * draft.direction;

  const Int c = dot(draft.center, draft.center) - draft.radius * draft.radius;
  if (c > 0) draft.promise.kind = SphereKind::miss;
  if (c == 0) draft.promise = {SphereKind::tangent, one_mark(Mark{0, 1})};
  if (c < 0) draft.promise = forward_promise(SphereKind::secant);
  return draft;
}

namespace {
struct BZero {
  static constexpr std::string_view name = "b-zero";
  static constexpr std::string_view attacks = "the origin is the line's closest point to the center";
  static constexpr Note note{"the stable quadratic with sgn(0) = 0",
                             "zero divided by zero, or both roots lost, from the center or beside it",
                             "arborx/ArborX pull request 461, review: the roots are wrong at b = 0"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    return finish<T>(b_zero_draft(random, digits<T>), random, index);
  }
};
}  // namespace

Family b_zero_family() {
  return family_of<BZero>();
}

}  // namespace graze::fuzz::construct
