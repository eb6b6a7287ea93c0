// unimodular. P, Q, R are the rows of an integer matrix of determinant +1 or -1 with entries of up to fifty bits, the corners
// of the triangle seen from the ray's origin. With d = i P + j Q + k R, for small i, j, k, the edge signs det(d, P, Q) ... are
// k, i, j, and the sign of d.n is that of i + j + k: 0 and +-1 where the products have 150 bits. All positive hits the face,
// a zero an edge, two a corner; i + j + k = 0 runs parallel. With R = x P + y Q instead (determinant 0) the origin lies in the
// plane of the triangle: inside, on the boundary, outside or, for d in that plane, coplanar.
#include <algorithm>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

using Rows = std::array<IntVec, 3>;

/// A product of random elementary matrices whose entries stay below 2^bits.
Rows choose_unimodular(Random& random, int bits) {
  Rows rows{IntVec{1, 0, 0}, IntVec{0, 1, 0}, IntVec{0, 0, 1}};
  const int factor_bits = random.between(1 + bits / 8, 1 + bits / 3);
  int refused = 0;
  while (refused < 6) {
    const std::size_t to = random.below(3);
    const std::size_t from = (to + 1 + random.below(2)) % 3;
    const Int factor = choose_integer(random, factor_bits);
    const IntVec next = rows[to] + factor * rows[from];
    if (bit_length(next) > bits) {
      ++refused;
    } else {
      rows[to] = next;
    }
  }
  return rows;
}

/// The kind where the direction is a P + b Q + c R for independent P, Q, R.
TriangleKind kind_by_parts(const std::array<Int, 3>& part) {
  const Int sum = part[0] + part[1] + part[2];
  if (sum == 0) return TriangleKind::miss;
  int zeros = 0, last_zero = 0, last_other = 0;
  for (int corner = 0; corner < 3; ++corner) {
    const int sign = sign_of(part[static_cast<std::size_t>(corner)]) * sign_of(sum);
    if (sign < 0) return TriangleKind::miss;
    (sign == 0 ? last_zero : last_other) = corner;
    zeros += sign == 0 ? 1 : 0;
  }
  return zeros == 2 ? vertex(last_other) : zeros == 1 ? opposite_edge(last_zero) : TriangleKind::face;
}

Int small_part(Random& random, int bits) {
  const bool tiny = !random.one_in(3);
  return random.one_in(3) ? 0 : choose_integer(random, tiny ? std::min(bits, 2) : bits);
}

TriangleDraft independent_corners(Random& random, const Rows& rows, int part_bits) {
  std::array<Int, 3> part{};
  for (Int& p : part) p = small_part(random, part_bits);
  if (part[0] == 0 && part[1] == 0) part[2] = part[2] == 0 ? 1 : part[2];
  const Int sum = part[0] + part[1] + part[2];
  TriangleDraft draft;
  draft.corner = rows;
  draft.direction = part[0] * rows[0] + part[1] * rows[1] + part[2] * rows[2];
  draft.promise.kind = kind_by_parts(part);
  if (sum != 0) draft.promise.marks = one_mark(make_mark(1, sum));
  return draft;
}

/// The origin in the triangle's plane: P, Q and x P + y Q.
TriangleDraft dependent_corners(Random& random, const Rows& rows, int part_bits) {
  Int x = small_part(random, part_bits);
  const Int y = small_part(random, part_bits);
  if (x + y == 1) x -= 2;  // else the corners lie on one line
  TriangleDraft draft;
  draft.corner = {rows[0], rows[1], x * rows[0] + y * rows[1]};
  const bool in_plane = random.one_in(3);
  const Int i = small_part(random, part_bits);
  const Int j = small_part(random, part_bits);
  draft.direction = i * rows[0] + j * rows[1];
  if (in_plane && (i != 0 || j != 0)) {
    // 0 = -x P - y Q + R: the triangle holds the origin where -x and -y are not negative.
    if (x <= 0 && y <= 0) draft.promise = forward_promise(TriangleKind::coplanar);
    return draft;
  }
  draft.direction = draft.direction + random.sign() * rows[2];
  draft.promise = {kind_by_parts({-x, -y, 1}), one_mark(Mark{0, 1})};
  return draft;
}

}  // namespace

TriangleDraft unimodular_draft(Random& random, int digits) {
  const int part_bits = random.between(1, digits / 8);
  const int entry_bits = choose_bits(random, 2, digits - 3 - part_bits);
  const Rows rows = choose_unimodular(random, entry_bits);
  return random.one_in(3) ? dependent_corners(random, rows, part_bits) : independent_corners(random, rows, part_bits);
}

namespace {
struct Unimodular {
  static constexpr std::string_view name = "unimodular";
  static constexpr std::string_view attacks = "edge, plane and parallel determinants of 0 and +-1 with fifty-bit entries";
  static constexpr Note note{"3x3 determinants in working precision",
                             "the wrong side of an edge, or a parallel ray that meets the plane",
                             "cnr-isti-vclab/vcglib issue 245: hits near triangle edges fail"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.mixed_axes = index % 16 >= 12;
    return finish<T>(unimodular_draft(random, digits<T>), random, index, plan);
  }
};
}  // namespace

Family unimodular_family() {
  return family_of<Unimodular>();
}

}  // namespace graze::fuzz::construct
