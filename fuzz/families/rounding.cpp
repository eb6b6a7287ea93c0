// rounding. Values that lie exactly between two numbers of the format, or closer to there than any fixed extra precision tells:
// - roots l +- h on an axis, with r^2 = m^2 + n^2 + h^2: a sum of two full mantissas has one digit more, a tie;
// - the same with h^2 +- 1 or a little for a square, so that the root misses the tie by 1 / (2h);
// - t = j / alpha of a tangent, a root or a triangle, and u = i / q with 2^s j = (2M + 1) alpha +- 1: the quotients nearest to
// a midpoint that there are;
// - t = a_z - e_z and u = (e_x - a_x) / 2^s, differences of full mantissas, among them the tie between the largest number and
//   overflow.
// Then t is scaled to where results are subnormal, round to zero from either side (a miss if t < 0), or overflow.
#include <algorithm>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// l such that l + h is odd and has one digit too many; h positive, at most `digits` digits.
Int choose_tie_partner(Random& random, Int h, int digits) {
  const Int below = residue(choose_natural(random, digits), h);
  const Int l = power_of_two(digits) - 1 - below;
  return ((l ^ h) & 1) != 0 || l == 0 ? l : l - 1;
}

SphereDraft axis_ray(Int l, Int m, Int n, Int r) {
  SphereDraft draft;
  draft.direction = {1, 0, 0};
  draft.center = {l, m, n};
  draft.radius = r;
  return draft;
}

SphereDraft root_tie(Random& random, int digits) {
  Int h = 0, m = 0, n = 0, r = 0;
  if (random.one_in(3)) {
    const int bits = choose_bits(random, 1, digits);
    h = r = choose_full(random, bits);
  } else {
    const int quaternion_bits = choose_bits(random, 1, (digits - 3) / 2);
    const Frame frame = choose_frame(random, quaternion_bits);
    h = magnitude(frame.r1.x);
    m = frame.r1.y;
    n = frame.r1.z;
    r = frame.length;
    if (h == 0) {
      SphereDraft touching = axis_ray(m, r, 0, r);
      touching.promise = {SphereKind::tangent, one_mark(Mark{m, 1})};
      return touching;
    }
  }
  const Int partner = choose_tie_partner(random, h, digits);
  const Int l = random.sign() * partner;
  SphereDraft draft = axis_ray(l, m, n, r);
  draft.promise = {SphereKind::secant, two_marks(Mark{l - h, 1}, Mark{l + h, 1})};
  return draft;
}

SphereDraft root_near_tie(Random& random, int digits) {
  if (random.one_in(2)) {
    // D = h^2 - m^2 with r = h.
    const int bits = choose_bits(random, 3, digits);
    const Int h = choose_full(random, bits);
    const Int m = random.between(1, 3);
    const Int l = choose_tie_partner(random, h, digits);
    SphereDraft draft = axis_ray(l, m, 0, h);
    if (l > h) draft.promise = forward_promise(SphereKind::secant);
    return draft;
  }
  // D = h^2 + 1 with r = h + 1 and m^2 = 2h.
  const int bits = choose_bits(random, 2, (digits - 1) / 2);
  const Int m = 2 * choose_full(random, bits);
  const Int h = m * m / 2;
  const Int l = choose_tie_partner(random, h, digits);
  SphereDraft draft = axis_ray(l, m, 0, h + 1);
  if (l > h + 1) draft.promise = forward_promise(SphereKind::secant);
  return draft;
}

SphereDraft tangent_near_midpoint(Random& random, int digits) {
  const int quaternion_bits = random.between(1, digits / 4);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int room = digits - 2 - bit_length(frame.length);
  const Quotient t = near_midpoint(random, choose_bits(random, 1, room), digits);
  const Int beta = choose_integer(random, room);
  SphereDraft draft;
  draft.direction = t.den * frame.r1;
  draft.center = t.num * frame.r1 + beta * frame.r2;
  draft.radius = magnitude(beta) * frame.length;
  draft.promise = {SphereKind::tangent, one_mark(Mark{t.num, t.den})};
  return draft;
}

/// Roots (j - k) / alpha and (j + k) / alpha in a frame, c - e = j R1 + beta R2 and r = N z with beta^2 + k^2 = z^2; the second
/// one beside a midpoint. The discriminant is a square, but not in a way that its factors show.
SphereDraft root_near_midpoint(Random& random, int digits) {
  static constexpr int triples[4][3] = {{3, 4, 5}, {15, 8, 17}, {20, 21, 29}, {0, 1, 1}};
  const auto& triple = triples[random.below(4)];
  const int quaternion_bits = random.between(1, digits / 5);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int room = digits - 2 - bit_length(frame.length);
  const Quotient t = near_midpoint(random, choose_bits(random, 1, room), digits);
  const int size_bits = random.between(1, room - 5);
  const Int size = choose_full(random, size_bits);
  const Int k = triple[1] * size;
  const Int j = t.num - k;
  SphereDraft draft;
  draft.direction = t.den * frame.r1;
  draft.center = j * frame.r1 + (triple[0] * size) * frame.r2;
  draft.radius = (triple[2] * size) * frame.length;
  draft.promise = {SphereKind::secant, two_marks(Mark{j - k, t.den}, Mark{t.num, t.den})};
  return draft;
}

TriangleDraft values_near_midpoints(Random& random, int digits) {
  const int part_bits = choose_bits(random, 1, digits / 2);
  const int edge_bits = random.between(1, digits - 4 - part_bits);
  const int direction_bits = random.between(1, digits / 2);
  const Quotient u = near_midpoint(random, part_bits, digits);
  const Quotient t = near_midpoint(random, digits - 3 - direction_bits, digits);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = choose_vector(random, edge_bits);
  aim.point = {u.num, random.one_in(2) ? 0 : u.den - u.num, u.den};
  if (random.one_in(2)) std::swap(aim.point.i, aim.point.j);
  aim.d = choose_vector(random, direction_bits);
  aim.tau = t.num;
  aim.alpha = t.den;
  return aimed_triangle(aim);
}

TriangleDraft t_tie(Random& random, int digits) {
  const int part_bits = random.between(1, digits / 3);
  const int edge_bits = choose_bits(random, 1, digits - 3 - part_bits);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = choose_vector(random, edge_bits);
  aim.e1.z = aim.e2.z = 0;
  aim.point = choose_point(random, part_bits);
  aim.d = {0, 0, 1};
  const Int height = choose_full(random, digits);
  const Int plane = random.one_in(4) ? power_of_two(digits) : choose_tie_partner(random, height, digits);
  aim.tau = height + plane;
  if (plane == power_of_two(digits)) aim.tau = 2 * plane - 1;
  TriangleDraft draft = aimed_triangle(aim);
  each_position(draft, [&](IntVec& v) { v.z += plane; });
  return draft;
}

/// u = (e_x - a_x) / 2^(digits + 1) and v = (e_y - a_y) / 2^(digits + 2), both with one digit too many.
TriangleDraft uv_tie(Random& random, int digits) {
  const Int ax = -2 * choose_full(random, digits - 1);
  const Int ay = -4 * choose_full(random, digits - 2);
  const Int ex = choose_full(random, digits) | 1;
  const Int ey = choose_full(random, digits) | 1;
  const Int tau = choose_natural(random, digits);
  const Int width = power_of_two(digits + 1);
  TriangleDraft draft;
  draft.origin = {ex, ey, -tau};
  draft.direction = {0, 0, 1};
  draft.corner = {IntVec{ax, ay, 0}, IntVec{ax + width, ay, 0}, IntVec{ax, ay + 2 * width, 0}};
  const bool is_inside = 2 * (ex - ax) + (ey - ay) < 2 * width;  // never equal: e_y - a_y is odd
  draft.promise = {is_inside ? TriangleKind::face : TriangleKind::miss, one_mark(Mark{tau, 1})};
  return draft;
}

Draft choose_draft(Random& random, int digits, bool is_triangle) {
  if (is_triangle) {
    switch (random.below(4)) {
      case 0:
        return t_tie(random, digits);
      case 1:
        return uv_tie(random, digits);
      case 2:
        return values_near_midpoints(random, digits);
      default:
        return any_triangle_draft(random, digits);
    }
  }
  switch (random.below(5)) {
    case 0:
      return root_tie(random, digits);
    case 1:
      return root_near_tie(random, digits);
    case 2:
      return root_near_midpoint(random, digits);
    case 3:
      return tangent_near_midpoint(random, digits);
    default:
      return any_sphere_draft(random, digits);
  }
}

/// An exponent that takes t to the subnormal numbers, below them, or to overflow; none half of the time.
template <Real T>
std::optional<int> choose_t_exponent(Random& random, const Marks& marks) {
  const Mark mark = marks.count != 0 ? marks.at[0] : Mark{1, 1};
  const int length = bit_length(mark.num) - bit_length(mark.den);
  switch (random.below(10)) {
    case 0:
      return least_exponent<T> - 1;  // odd integers become ties
    case 1:
      return least_exponent<T> - length + random.between(-3, 3);
    case 2:
      return least_exponent<T> - length + random.between(0, digits<T>);
    case 3:
      return least_exponent<T> - length - random.between(2, 60);
    case 4:
      return end_exponent<T> - length + random.between(-1, 1);
    default:
      return std::nullopt;
  }
}

struct Rounding {
  static constexpr std::string_view name = "rounding";
  static constexpr std::string_view attacks = "exact ties and near-ties of t, u, v; subnormal, vanishing and overflowing t";
  static constexpr Note note{"numbers rounded more than once; subnormal and overflowing results forgotten",
                             "another t on another compiler or processor; -0 or NaN for t",
                             "none seen; the promise that it holds is graze's own"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Draft draft = choose_draft(random, digits<T>, is_triangle_index(index));
    const bool is_behind = random.one_in(4);
    Plan plan;
    std::visit(
        [&](auto& any) {
          if (is_behind) reverse(any);
          plan.t_exponent = choose_t_exponent<T>(random, any.promise.marks);
        },
        draft);
    plan.translate = random.one_in(2);
    return finish<T>(draft, random, index, plan);
  }
};

}  // namespace

Family rounding_family() {
  return family_of<Rounding>();
}

}  // namespace graze::fuzz::construct
