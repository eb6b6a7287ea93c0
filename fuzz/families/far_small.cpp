// far-small. Shapes whose distance is 2^10 to 2^60 times their size, hit on the boundary. Along an axis any ratio is exact: a
// direction (alpha, 0, 0), a sphere with m^2 + n^2 = r^2 aside, or a triangle point with x = 0. In general directions the frame
// of a small quaternion leaves most of the mantissa to the distance; where it needs more digits than there are the coordinates
// are cut off and the promise with them. Others are near, but both lie far from zero: a common offset that uses up the
// mantissa, so that c - e cancels. |d x L|^2 from rounded L, and B^2 - A C, lose the sphere altogether.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// A distance with at most `digits` significant digits, 2^10 to 2^60 times a size.
Int choose_distance(Random& random, int size_bits, int digits) {
  const int ratio = random.between(10, 60);
  const int length = size_bits + ratio;
  const int significant = choose_bits(random, 1, digits < length ? digits : length);
  const Int leading = choose_full(random, significant);
  return leading * power_of_two(length - significant);
}

SphereDraft far_sphere_on_axis(Random& random, int digits) {
  const int bits = choose_bits(random, 1, digits / 2 - 1);
  const Int p = choose_integer(random, bits);
  const Int q = random.one_in(3) ? 0 : choose_integer(random, bits);
  SphereDraft draft;
  draft.center.y = p * p - q * q;
  draft.center.z = 2 * p * q;
  draft.radius = p * p + q * q;
  draft.center.x = choose_distance(random, bit_length(draft.radius), digits);
  const Int alpha = choose_factor(random, digits);
  draft.direction = {alpha, 0, 0};
  draft.promise = {SphereKind::tangent, one_mark(make_mark(draft.center.x, alpha))};
  if (random.one_in(4)) {
    draft.radius += draft.radius == 0 || random.one_in(2) ? 1 : -1;
    draft.promise = {};
  }
  return draft;
}

SphereDraft far_sphere_in_frame(Random& random, int digits) {
  const int quaternion_bits = random.between(1, digits / 8);
  const Frame frame = choose_frame(random, quaternion_bits);
  const int ratio = random.between(10, random.one_in(3) ? 60 : digits - 3 - bit_length(frame.length));
  const Int j = choose_full(random, ratio < 10 ? 10 : ratio);
  const Int alpha = choose_factor(random, digits - bit_length(frame.length));
  SphereDraft draft;
  draft.direction = alpha * frame.r1;
  draft.center = j * frame.r1 + random.sign() * frame.r2;
  draft.radius = frame.length;
  draft.promise = {SphereKind::tangent, one_mark(make_mark(j, alpha))};
  return draft;
}

TriangleDraft far_triangle(Random& random, int digits) {
  const int size_bits = random.between(1, digits / 3);
  const int part_bits = random.between(1, 4);
  Aim aim;
  aim.e1 = choose_vector(random, size_bits);
  aim.e2 = choose_vector(random, size_bits);
  aim.point = choose_point(random, part_bits);
  if (random.one_in(2)) {
    aim.d = {1, 0, 0};
    aim.alpha = choose_factor(random, digits);
    aim.tau = choose_distance(random, size_bits + part_bits, digits);
    TriangleDraft draft = aimed_triangle(aim);
    const Int shift = aim.point.i * aim.e1.x + aim.point.j * aim.e2.x;  // moves the target to x = 0
    each_position(draft, [&](IntVec& v) { v.x -= shift; });
    return draft;
  }
  const int room = digits - 3 - size_bits - part_bits;
  const int direction_bits = random.between(1, room / 2);
  aim.d = choose_vector(random, direction_bits);
  aim.alpha = choose_factor(random, digits - direction_bits);
  aim.tau = choose_full(random, digits - 2 - direction_bits);
  return aimed_triangle(aim);
}

/// Everything a small distance apart, at 2^10 to 2^digits times that from zero.
template <class AnyDraft>
void move_away(AnyDraft& draft, Random& random, int digits) {
  const int size_bits = position_bits(draft);
  const int offset_bits = choose_bits(random, size_bits + (digits - size_bits) / 2, digits - 1);
  const IntVec offset = choose_vector(random, offset_bits);
  each_position(draft, [&](IntVec& v) { v = v + offset; });
}

struct FarSmall {
  static constexpr std::string_view name = "far-small";
  static constexpr std::string_view attacks = "shapes small beside their distance, or beside a common offset";
  static constexpr Note note{"L.L - r^2 computed as the difference of two large squares",
                             "circles of noise on distant spheres; small spheres missed",
                             "mitsuba-renderer/mitsuba3 issue 512; ziotom78/pytracer issue 22"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.translate = false;
    const std::uint64_t way = random.below(3);
    if (way == 0) {
      Draft draft = any_draft(random, digits<T> / 2, is_triangle_index(index));
      std::visit([&](auto& any) { move_away(any, random, digits<T>); }, draft);
      return finish<T>(draft, random, index, plan);
    }
    if (is_triangle_index(index)) return finish<T>(far_triangle(random, digits<T>), random, index, plan);
    if (way == 1) return finish<T>(far_sphere_on_axis(random, digits<T>), random, index, plan);
    return finish<T>(far_sphere_in_frame(random, digits<T>), random, index, plan);
  }
};

}  // namespace

Family far_small_family() {
  return family_of<FarSmall>();
}

}  // namespace graze::fuzz::construct
