// Per target: rounding/face.cpp, on four lanes with FMA where the target has both. Included anew for each target by
// kernels.cpp.
#if defined(GRAZE_SCENE_FACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_FACE_INL
#undef GRAZE_SCENE_FACE_INL
#else
#define GRAZE_SCENE_FACE_INL
#endif

#include "rounding/quotients.hpp"
#include "scene/boxes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_NATIVE_FMA && HWY_MAX_BYTES >= 32

using Four = hn::CappedTag<double, 4>;
using FourLanes = hn::Vec<Four>;

/// As numeric::PairLanes, operation by operation.
struct FourPairs {
  FourLanes hi, lo;
};

HWY_INLINE FourPairs two_sum(FourLanes a, FourLanes b) {
  const FourLanes s = hn::Add(a, b), bb = hn::Sub(s, a);
  return {s, hn::Add(hn::Sub(a, hn::Sub(s, bb)), hn::Sub(b, bb))};
}
HWY_INLINE FourPairs two_difference(FourLanes a, FourLanes b) {
  const FourLanes s = hn::Sub(a, b), bb = hn::Sub(s, a);
  return {s, hn::Sub(hn::Sub(a, hn::Sub(s, bb)), hn::Add(b, bb))};
}
HWY_INLINE FourPairs product(FourLanes a, FourLanes b) {
  const FourLanes p = hn::Mul(a, b);
  return {p, hn::MulSub(a, b, p)};
}
HWY_INLINE FourPairs product(FourLanes a, const FourPairs& b) {
  const FourPairs p = product(a, b.hi);
  return {p.hi, hn::Add(p.lo, hn::Mul(a, b.lo))};
}
HWY_INLINE FourPairs product(const FourPairs& a, const FourPairs& b) {
  const FourPairs p = product(a.hi, b.hi);
  return {p.hi, hn::Add(p.lo, hn::Add(hn::Mul(a.hi, b.lo), hn::Mul(a.lo, b.hi)))};
}
HWY_INLINE FourPairs sum(const FourPairs& a, const FourPairs& b) {
  const FourPairs s = two_sum(a.hi, b.hi);
  return {s.hi, hn::Add(s.lo, hn::Add(a.lo, b.lo))};
}
HWY_INLINE FourPairs difference(const FourPairs& a, const FourPairs& b) {
  const FourPairs s = two_difference(a.hi, b.hi);
  return {s.hi, hn::Add(s.lo, hn::Sub(a.lo, b.lo))};
}
/// y, z, x, w.
HWY_INLINE FourLanes rotated(FourLanes v) {
  alignas(32) static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(Four(), order));
}
HWY_INLINE FourPairs rotated(const FourPairs& v) {
  return {rotated(v.hi), rotated(v.lo)};
}
template <class A>
HWY_INLINE FourPairs cross(const A& a, const FourPairs& b) {
  return rotated(difference(product(a, rotated(b)), product(rotated(a), b)));
}
/// Of each of the four the sum of its lanes.
HWY_INLINE FourPairs sums(const FourPairs& a, const FourPairs& b, const FourPairs& c, const FourPairs& d) {
  const Four f;
  struct Columns {
    FourLanes first, second, third, fourth;
  };
  const auto transposed = [f](FourLanes p, FourLanes q, FourLanes r, FourLanes s) HWY_ATTR {
    const FourLanes even = hn::InterleaveLower(f, p, q), odd = hn::InterleaveUpper(f, p, q);
    const FourLanes other_even = hn::InterleaveLower(f, r, s), other_odd = hn::InterleaveUpper(f, r, s);
    return Columns{hn::ConcatLowerLower(f, other_even, even), hn::ConcatLowerLower(f, other_odd, odd),
                   hn::ConcatUpperUpper(f, other_even, even), hn::ConcatUpperUpper(f, other_odd, odd)};
  };
  const Columns hi = transposed(a.hi, b.hi, c.hi, d.hi), lo = transposed(a.lo, b.lo, c.lo, d.lo);
  return sum(sum({hi.first, lo.first}, {hi.second, lo.second}), sum({hi.third, lo.third}, {hi.fourth, lo.fourth}));
}

/// x, y, z and a fourth number.
HWY_INLINE FourLanes set(double x, double y, double z) {
  const Four d;
  return hn::ConcatLowerLower(d, hn::Set(d, z), hn::InterleaveLower(d, hn::Set(d, x), hn::Set(d, y)));
}
HWY_INLINE FourLanes set(float x, float y, float z) {
  const hn::Rebind<float, Four> d;
  return hn::PromoteTo(Four(), hn::ConcatLowerLower(d, hn::Set(d, z), hn::InterleaveLower(d, hn::Set(d, x), hn::Set(d, y))));
}
template <Real T>
HWY_INLINE FourLanes vector(const Vec3<T>& v) {
  return set(v.x, v.y, v.z);
}
template <Real T>
HWY_INLINE FourLanes corner(const TriangleBlock<T>& block, int lane, int c) {
  return set(block.corners[c][0][lane], block.corners[c][1][lane], block.corners[c][2][lane]);
}

/// t, u, v of a block's triangle in whose face the ray is known to hit it; false where they are not certain.
HWY_INLINE bool round_face(const Ray<double>& ray, const TriangleBlock<double>& block, int lane,
                           const rounding::FaceBounds& bounds, TriangleHit<double>& hit) {
  const Four f;
  const auto xyz = [f](FourLanes v) HWY_ATTR { return hn::IfThenElseZero(hn::FirstN(f, 3), v); };
  const FourLanes a = xyz(corner(block, lane, 0)), d = xyz(vector(ray.direction));
  const FourPairs e1 = two_difference(xyz(corner(block, lane, 1)), a), e2 = two_difference(xyz(corner(block, lane, 2)), a);
  const FourPairs t = two_difference(xyz(vector(ray.origin)), a), h = cross(d, e2), g = cross(t, e1);
  const FourPairs unnormalised = sums(product(e2, g), product(t, h), product(d, g), product(e1, h));
  const FourPairs n = two_sum(unnormalised.hi, unnormalised.lo);
  alignas(32) double hi[4], lo[4];
  hn::Store(n.hi, f, hi);
  hn::Store(n.lo, f, lo);
  const double determinant = hi[3];
  const FourLanes d_hi = hn::Set(f, hi[3]), d_lo = hn::Set(f, lo[3]), q = hn::Div(n.hi, d_hi);
  const FourPairs p = product(q, d_hi);
  const FourLanes rest = hn::Add(hn::Sub(hn::Sub(n.hi, p.hi), p.lo), hn::Sub(n.lo, hn::Mul(q, d_lo)));
  hn::Store(q, f, hi);
  hn::Store(hn::Div(rest, d_hi), f, lo);
  using numeric::Lanes;
  const rounding::Quotients quotients =
      rounding::with_pair_errors(Lanes{hi[0], hi[1], hi[2], 0}, Lanes{lo[0], lo[1], lo[2], 0}, determinant, bounds);
  return rounding::round_certainly(quotients, bounds, hit);
}

HWY_INLINE FourLanes cross(FourLanes a, FourLanes b) {
  return rotated(hn::MulSub(a, rotated(b), hn::Mul(rotated(a), b)));
}
/// Of each of the four the sum of its first three lanes.
HWY_INLINE FourLanes sums(FourLanes a, FourLanes b, FourLanes c, FourLanes d) {
  const Four f;
  const FourLanes ab_even = hn::InterleaveLower(f, a, b), ab_odd = hn::InterleaveUpper(f, a, b);
  const FourLanes cd_even = hn::InterleaveLower(f, c, d), cd_odd = hn::InterleaveUpper(f, c, d);
  return hn::Add(hn::Add(hn::ConcatLowerLower(f, cd_even, ab_even), hn::ConcatLowerLower(f, cd_odd, ab_odd)),
                 hn::ConcatUpperUpper(f, cd_even, ab_even));
}

/// The same for float, from determinants in double: rounding::with_errors and rounding::rounds_certainly on lanes.
HWY_INLINE bool round_face(const Ray<float>& ray, const TriangleBlock<float>& block, int lane,
                           const rounding::FaceBounds& bounds, TriangleHit<float>& hit) {
  const Four f;
  const hn::Rebind<float, Four> narrow;
  const auto set_all = [f](double x) HWY_ATTR { return hn::Set(f, x); };
  const FourLanes a = corner(block, lane, 0), d = vector(ray.direction);
  const FourLanes e1 = hn::Sub(corner(block, lane, 1), a), e2 = hn::Sub(corner(block, lane, 2), a);
  const FourLanes t = hn::Sub(vector(ray.origin), a), h = cross(d, e2), g = cross(t, e1);
  // The distance, u, v and the determinant.
  const FourLanes n = sums(hn::Mul(e2, g), hn::Mul(t, h), hn::Mul(d, g), hn::Mul(e1, h));
  const FourLanes determinant = hn::ConcatUpperUpper(f, n, n), whole = hn::InterleaveUpper(f, determinant, determinant);
  const FourLanes q = hn::Div(n, whole), size = hn::Abs(q), whole_size = hn::Abs(whole);
  const FourLanes scale = hn::Div(set_all(1 + rounding::second_order), whole_size);
  const FourLanes n_error = hn::IfThenElse(hn::FirstN(f, 1), set_all(bounds.distance_error), set_all(bounds.error));
  const FourLanes error =
      hn::MulAdd(hn::MulAdd(size, set_all(bounds.error), n_error), scale, hn::Mul(size, set_all(rounding::quotient_error)));
  const FourLanes margin =
      hn::MulAdd(error, set_all(1 + rounding::margin_share), hn::Mul(size, set_all(rounding::float_sum_error)));
  const auto below = hn::DemoteTo(narrow, hn::Sub(q, margin)), above = hn::DemoteTo(narrow, hn::Add(q, margin));
  const auto is_bounded = hn::Gt(whole_size, set_all(rounding::certainty * bounds.error));
  const auto is_ordinary = hn::And(hn::Gt(size, set_all(0x1p-125)), hn::Lt(size, set_all(0x1p126)));
  const unsigned certain = bits_of_mask(narrow, hn::Eq(below, above)) & bits_of_mask(f, hn::And(is_ordinary, is_bounded));
  alignas(16) float numbers[4];
  hn::Store(below, narrow, numbers);
  hit.t = hit.t_end = numbers[0];
  hit.u = numbers[1];
  hit.v = numbers[2];
  hit.kind = TriangleKind::face;
  hit.facing = bounds.is_front ? Facing::front : Facing::back;
  return (certain & 7) == 7;
}

template <Real T>
HWY_NOINLINE HWY_FLATTEN void face(const Ray<T>& ray, const TriangleBlock<T>& block, int lane,
                                   const rounding::FaceBounds& bounds, TriangleHit<T>& hit) noexcept {
  if (HWY_LIKELY(numeric::rounds_to_nearest() && round_face(ray, block, lane, bounds, hit))) return;
  hit = exact::intersect(ray, block.triangle(lane));
}

#else

template <Real T>
void face(const Ray<T>& ray, const TriangleBlock<T>& block, int lane, const rounding::FaceBounds&,
          TriangleHit<T>& hit) noexcept {
  const Triangle<T> triangle = block.triangle(lane);
  hit = rounding::face(ray, triangle, predicates::triangle_terms<double>(ray, triangle));
}

#endif

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
