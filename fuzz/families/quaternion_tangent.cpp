// quaternion-tangent. An integer quaternion gives three orthogonal integer columns R1 R2 R3 of equal length N. With d = alpha
// R1, c = e + j R1 + beta R2 and r = |beta| N, the line touches the sphere at t = j / alpha exactly. Some take beta (x R2 + y
// R3) with x^2 + y^2 = z^2 and r = |beta| z N instead. Once coordinates exceed half the mantissa the discriminant B^2 - A C is
// a difference of two rounded numbers of twice the digits, and its true value 0 drowns.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

SphereDraft quaternion_tangent_draft(Random& random, int digits) {
  const int quaternion_bits = choose_bits(random, 1, (digits - 5) / 2);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int room = digits - 2 - bit_length(frame.length);

  IntVec aside = frame.r2;
  Int aside_length = frame.length;
  int aside_room = room;
  if (room > 6 && random.one_in(3)) {
    static constexpr int triples[4][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
    const auto& triple = triples[random.below(4)];
    aside = triple[0] * frame.r2 + triple[1] * frame.r3;
    aside_length = triple[2] * frame.length;
    aside_room = room - 5;
  }

  const int along_bits = choose_bits(random, 1, room);
  const Int j = choose_way(random, along_bits);
  const int aside_bits = choose_bits(random, 1, aside_room);
  const Int beta = choose_integer(random, aside_bits);
  const Int alpha = choose_factor(random, digits - bit_length(frame.length));

  SphereDraft draft;
  draft.direction = alpha * frame.r1;
  draft.center = j * frame.r1 + beta * aside;
  draft.radius = magnitude(beta) * aside_length;
  draft.promise = {SphereKind::tangent, one_mark(make_mark(j, alpha))};
  return draft;
}

namespace {
struct QuaternionTangent {
  static constexpr std::string_view name = "quaternion-tangent";
  static constexpr std::string_view attacks = "discriminant exactly 0 with full mantissas; A is a square";
  static constexpr Note note{"the discriminant computed with rounding, compared with 0",
                             "a touching ray is lost, or two roots are told where there is one",
                             "RayTracing/raytracing.github.io issue 1058: the book's sphere rejected a discriminant of 0"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    return finish<T>(quaternion_tangent_draft(random, digits<T>), random, index);
  }
};
}  // namespace

Family quaternion_tangent_family() {
  return family_of<QuaternionTangent>();
}

}  // namespace graze::fuzz::construct
