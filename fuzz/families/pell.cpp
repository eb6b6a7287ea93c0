// pell. For d = (p, q, 0) and c - e = (l, m, n) the quartered discriminant is A (r^2 - n^2) - s^2 with A = p^2 + q^2 and s = p
// m - q l. With r^2 - n^2 = y^2 and s / y a convergent of sqrt(A) it is the norm of that convergent: -1 or +1 at the end of a
// period, and below 2 sqrt(A) everywhere, beside squares of 100 digits. l and m come from Bezout; a multiple of d added to c
// moves t alone. No tangent is among them: A is not a square. The nearest miss and the nearest secant that integers allow.
#include <utility>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

struct Convergent {
  Int s = 1, y = 0;  ///< s / y, about sqrt(A)
};

/// A convergent of sqrt(a), a not a square, with y below 2^bits; one of norm +1 or -1 three times in four, if there is one.
Convergent choose_convergent(Random& random, Int a, int bits) {
  const Int root = integer_sqrt(a);
  Convergent before{1, 0}, now{root, 1}, unit{1, 0};
  Int m = 0, norm = 1, quotient = root;
  while (true) {
    m = norm * quotient - m;
    norm = (a - m * m) / norm;  // now.s^2 - a now.y^2 is norm or -norm
    if (norm == 1) unit = now;
    quotient = (root + m) / norm;
    const Convergent next{quotient * now.s + before.s, quotient * now.y + before.y};
    if (bit_length(next.y) > bits) break;
    before = std::exchange(now, next);
  }
  return unit.y == 0 || random.one_in(4) ? now : unit;
}

/// What D, B and C say of the ray with t >= 0; D is not 0.
SphereKind kind_by_signs(Int d, Int b, Int c) {
  return d > 0 && (b >= 0 || c <= 0) ? SphereKind::secant : SphereKind::miss;
}

}  // namespace

SphereDraft pell_draft(Random& random, int digits) {
  const int direction_bits = random.one_in(2) ? random.between(1, 4) : random.between(1, digits / 2 - 4);
  IntVec d;
  Int a = 0;
  while (true) {
    d.x = choose_nonzero(random, direction_bits);
    d.y = choose_nonzero(random, direction_bits);
    d = primitive(d);
    a = dot(d, d);
    const Int root = integer_sqrt(a);
    if (root * root != a) break;
  }
  const int size_bits = choose_bits(random, digits / 4, digits - 3);
  const Convergent near = choose_convergent(random, a, size_bits);

  SphereDraft draft;
  draft.radius = near.y;
  if (near.y % 4 == 0 && random.one_in(2)) {
    draft.radius = near.y / 4 * 5;
    draft.center.z = near.y / 4 * 3;
  } else if (near.y % 3 == 0) {
    draft.radius = near.y / 3 * 5;
    draft.center.z = near.y / 3 * 4;
  }

  // Solve p m - q l = s, then move along d to beside the foot of the perpendicular, and on by j.
  const Bezout one = bezout(d.x, d.y);
  draft.center.y = residue(near.s * one.x, d.y);
  draft.center.x = (d.x * draft.center.y - near.s) / d.y;
  const Int back = nearest_quotient(draft.center.x * d.x + draft.center.y * d.y, a);
  const int along_bits = choose_bits(random, 1, digits - 2 - direction_bits);
  const Int onward = choose_way(random, along_bits);
  draft.center = draft.center + (onward - back) * d;

  // The squares may need more than 128 bits, their difference far fewer.
  const auto wrapped = [](Int n) { return static_cast<UnsignedInt>(n); };
  const auto norm = static_cast<Int>(wrapped(a) * wrapped(near.y) * wrapped(near.y) - wrapped(near.s) * wrapped(near.s));
  const Int b = dot(d, draft.center);
  const Int c = dot(draft.center, draft.center) - draft.radius * draft.radius;
  draft.promise = forward_promise(kind_by_signs(norm, b, c));
  const Int alpha = choose_factor(random, digits - direction_bits);
  draft.direction = alpha * d;
  if (alpha < 0) draft.promise = forward_promise(kind_by_signs(norm, -b, c));
  return draft;
}

namespace {
struct Pell {
  static constexpr std::string_view name = "pell";
  static constexpr std::string_view attacks = "discriminant +1 or -1 beside squares of a hundred digits";
  static constexpr Note note{"a discriminant of +1 or -1 lost beside the squares that it is the difference of",
                             "misses told as hits and hits as misses near the limb",
                             "mmp/pbrt-v3 issue 265: a dark ring near the limb of a sphere far from the origin"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    return finish<T>(pell_draft(random, digits<T>), random, index);
  }
};
}  // namespace

Family pell_family() {
  return family_of<Pell>();
}

}  // namespace graze::fuzz::construct
