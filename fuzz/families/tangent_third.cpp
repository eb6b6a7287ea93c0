// tangent-third. Tangent at a t that no binary number is: e = 0, d = (1, 2, 2), c = (1, 1, 0), r = 1 gives t = 1/3; its lattice
// scalings, and the general form. With R1 R2 R3 orthogonal of length N and any integer vector w: d = alpha R1,
// c - e = w x R3, r = |w . R1| is tangent at t = (w . R2) / (alpha N). The point of contact is not representable either, so
// whoever computes it first and then measures its distance is off.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

SphereDraft scaled_third(Random& random, int digits) {
  const int size_bits = choose_bits(random, 1, digits - 1);
  const Int s = choose_full(random, size_bits);
  const Int alpha = choose_factor(random, digits - 2);
  SphereDraft draft;
  draft.direction = alpha * IntVec{1, 2, 2};
  draft.center = s * IntVec{1, 1, 0};
  draft.radius = s;
  draft.promise = {SphereKind::tangent, one_mark(make_mark(s, 3 * alpha))};
  return draft;
}

SphereDraft general_third(Random& random, int digits) {
  const int quaternion_bits = choose_bits(random, 1, (digits - 7) / 2);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int vector_bits = choose_bits(random, 1, digits - 2 - bit_length(frame.length));
  IntVec w = choose_vector(random, vector_bits);
  if (dot(w, frame.r2) < 0 && !random.one_in(4)) w = -w;
  const IntVec offset = cross(w, frame.r3);
  const Int radius = magnitude(dot(w, frame.r1));
  const Int unit = gcd(content(offset), radius);
  const Int common = unit == 0 ? 1 : unit;
  const Int shared = content(frame.r1);  // divides the length; without it d is primitive
  const Int alpha = choose_factor(random, digits - bit_length(frame.length / shared));

  SphereDraft draft;
  draft.direction = alpha * (frame.r1 / shared);
  draft.center = offset / common;
  draft.radius = radius / common;
  // t along R1 / shared is shared times that along R1.
  const Int num = dot(w, frame.r2);
  const Int den = alpha * (frame.length / shared) * common;
  const Int reduce = gcd(num, den);
  draft.promise = {SphereKind::tangent, one_mark(make_mark(num / reduce, den / reduce))};
  return draft;
}

}  // namespace

SphereDraft tangent_third_draft(Random& random, int digits) {
  return random.one_in(3) ? scaled_third(random, digits) : general_third(random, digits);
}

namespace {
struct TangentThird {
  static constexpr std::string_view name = "tangent-third";
  static constexpr std::string_view attacks = "tangent where neither t nor the point of contact is representable";
  static constexpr Note note{"a test of the rounded point of contact instead of the exact discriminant",
                             "a touching ray is lost; t is off in its last places",
                             "MobilityDB/MobilityDB pull request 2071: one touching point read as two roots"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.translate = index % 8 >= 4;
    return finish<T>(tangent_third_draft(random, digits<T>), random, index, plan);
  }
};
}  // namespace

Family tangent_third_family() {
  return family_of<TangentThird>();
}

}  // namespace graze::fuzz::construct
