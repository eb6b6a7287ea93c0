// implicit. Points and lines, planes and spheres with f(p) exactly 0, +1 or -1 lattice unit. For lines and planes Bezout solves
// a x + b y = target with coefficients of full mantissas, so that products of a hundred digits cancel to the last one; or the
// constant takes up the sum of short products. Spheres: the edge of an integer frame, and the integer root of |p - c|^2 or the
// next number. Points and coefficients are scaled apart; where the constant is 0 even so far that every product underflows.
#include <algorithm>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// coefficient . point + constant = sign, a lattice unit or zero.
struct FlatDraft {
  IntVec point, coefficient;
  Int constant = 0;
  int sign = 0;
};

FlatDraft short_products(Random& random, int digits, bool is_plane) {
  const int point_bits = random.between(1, digits - 4);
  const int coefficient_bits = random.between(1, digits - 3 - point_bits);
  FlatDraft draft;
  draft.point = choose_vector(random, point_bits);
  draft.coefficient = choose_vector(random, coefficient_bits);
  if (!is_plane) draft.point.z = draft.coefficient.z = 0;
  draft.sign = random.between(-1, 1);
  draft.constant = draft.sign - dot(draft.coefficient, draft.point);
  return draft;
}

FlatDraft long_products(Random& random, int digits, bool is_plane) {
  const int coefficient_bits = choose_bits(random, 2, digits - 3);
  const int other_bits = choose_bits(random, 1, digits - 3);
  FlatDraft draft;
  draft.coefficient.x = choose_nonzero(random, coefficient_bits);
  draft.coefficient.y = choose_full(random, coefficient_bits);
  const Int common = gcd(draft.coefficient.x, draft.coefficient.y);
  draft.coefficient = draft.coefficient / common;
  if (is_plane) {
    draft.coefficient.z = choose_integer(random, coefficient_bits - bit_length(common) + 1);
    draft.point.z = choose_integer(random, other_bits);
  }
  if (!random.one_in(4)) draft.constant = choose_integer(random, other_bits);
  draft.sign = random.between(-1, 1);

  const Int target = draft.sign - draft.constant - draft.coefficient.z * draft.point.z;
  const Bezout one = bezout(draft.coefficient.x, draft.coefficient.y);
  const Int shift = residue(target, draft.coefficient.y) * residue(one.x, draft.coefficient.y);
  draft.point.x = residue(shift, draft.coefficient.y);
  draft.point.y = (target - draft.coefficient.x * draft.point.x) / draft.coefficient.y;
  return draft;
}

/// Exponents of the point and of the coefficients; the constant has their sum.
struct FlatScale {
  int point = 0, coefficient = 0;
};
template <Real T>
FlatScale choose_flat_scale(Random& random, const FlatDraft& draft) {
  FlatScale scale;
  const std::uint64_t roll = random.below(4);
  if (roll < 2) return scale;
  const int point_high = end_exponent<T> - bit_length(draft.point);
  const int coefficient_high = end_exponent<T> - bit_length(draft.coefficient);
  if (roll == 2) {
    scale.point = random.between(-digits<T>, digits<T>);
    scale.coefficient = random.between(-digits<T>, digits<T>);
  } else {
    scale.point = random.between(least_exponent<T>, point_high);
    int low = least_exponent<T>, high = coefficient_high;
    if (draft.constant != 0) {
      low = std::max(low, least_exponent<T> - scale.point);
      high = std::min(high, end_exponent<T> - bit_length(draft.constant) - scale.point);
    }
    scale.coefficient = random.between(low, high);
  }
  return scale;
}

template <Real T>
LabelledCase<T> make_flat(Random& random, bool is_plane) {
  FlatDraft draft = random.one_in(3) ? short_products(random, digits<T>, is_plane) : long_products(random, digits<T>, is_plane);
  if (random.one_in(32)) {
    draft.coefficient = {};
    draft.constant = draft.sign;
  }
  if (random.one_in(2)) {
    draft.coefficient = -draft.coefficient;
    draft.constant = -draft.constant;
    draft.sign = -draft.sign;
  }
  const int turn = is_plane ? random.between(0, 2) : 2 * random.between(0, 1);
  const FlatScale scale = choose_flat_scale<T>(random, draft);
  bool exact = true;
  std::array<T, 3> point{}, coefficient{};
  for (int axis = 0; axis < 3; ++axis) {
    // A line's x and y change places, with z between them unused; a plane's axes rotate.
    const int from = is_plane ? (axis + turn) % 3 : (turn != 0 && axis < 2 ? 1 - axis : axis);
    point[static_cast<std::size_t>(axis)] = scaled<T>(draft.point[from], scale.point, exact);
    coefficient[static_cast<std::size_t>(axis)] = scaled<T>(draft.coefficient[from], scale.coefficient, exact);
  }
  const T constant = scaled<T>(draft.constant, scale.point + scale.coefficient, exact);

  LabelledCase<T> result;
  if (is_plane) {
    result.input = PointPlane<T>{{point[0], point[1], point[2]}, {coefficient[0], coefficient[1], coefficient[2], constant}};
  } else {
    result.input = PointLine<T>{{point[0], point[1]}, {coefficient[0], coefficient[1], constant}};
  }
  if (exact) result.label.side = static_cast<Sign>(draft.sign);
  return result;
}

template <Real T>
LabelledCase<T> make_sphere(Random& random) {
  const int bits = choose_bits(random, 1, digits<T> - 3);
  IntVec offset = choose_vector(random, bits);
  if (random.one_in(2)) offset = choose_frame(random, (bits + 1) / 2).r1;
  const Int squared = dot(offset, offset);
  const Int root = integer_sqrt(squared);
  const Int radius = root + (random.one_in(3) ? random.between(0, 1) : 0);
  const int center_bits = choose_bits(random, 1, digits<T> - 1);
  const IntVec center = random.one_in(4) ? IntVec{} : choose_vector(random, center_bits);
  const IntVec point = center + offset;
  int exponent = 0;
  if (random.one_in(2)) {
    const int most = std::max({bit_length(point), bit_length(center), bit_length(radius)});
    exponent = random.between(least_exponent<T>, end_exponent<T> - most);
  }

  bool exact = true;
  const auto in_format = [&](Int n) { return scaled<T>(n, exponent, exact); };
  PointSphere<T> made;
  made.point = {in_format(point.x), in_format(point.y), in_format(point.z)};
  made.sphere = {{in_format(center.x), in_format(center.y), in_format(center.z)}, in_format(radius)};
  LabelledCase<T> result;
  result.input = made;
  if (exact) result.label.side = static_cast<Sign>(sign_of(squared - radius * radius));
  return result;
}

struct Implicit {
  static constexpr std::string_view name = "implicit";
  static constexpr std::string_view attacks = "points on lines, planes and spheres, or a lattice unit beside them";
  static constexpr Note note{
      "f(p) computed with rounding", "a point on the wrong side of a line, a plane or a sphere",
      "sixty-north.com/blog, Rational Computational Geometry in Python: the wrong side of a line in double"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    const std::uint64_t shape = (index / 4) % 3;
    LabelledCase<T> result = shape == 2 ? make_sphere<T>(random) : make_flat<T>(random, shape == 1);
    if (random.one_in(8)) flip_zeros(result.input, random);
    if (!is_pure_index(index)) {
      nudge(result.input, random);
      result.label = {};
    }
    return result;
  }
};

}  // namespace

Family implicit_family() {
  return family_of<Implicit>();
}

}  // namespace graze::fuzz::construct
