// Per target: rounding/face.cpp, on four lanes with FMA where the target has both. Included anew for each target by
// kernels.cpp.
#if defined(GRAZE_SCENE_FACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_FACE_INL
#undef GRAZE_SCENE_FACE_INL
#else
#define GRAZE_SCENE_FACE_INL
#endif

#include <cstddef>

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
/// The lanes of four vectors: their first numbers, their second, their third.
struct Columns {
  FourLanes first, second, third;
};
HWY_INLINE Columns transposed(FourLanes a, FourLanes b, FourLanes c, FourLanes d) {
  const Four f;
  const FourLanes ab_even = hn::InterleaveLower(f, a, b), ab_odd = hn::InterleaveUpper(f, a, b);
  const FourLanes cd_even = hn::InterleaveLower(f, c, d), cd_odd = hn::InterleaveUpper(f, c, d);
  return {hn::ConcatLowerLower(f, cd_even, ab_even), hn::ConcatLowerLower(f, cd_odd, ab_odd),
          hn::ConcatUpperUpper(f, cd_even, ab_even)};
}
/// Of each of the four the sum of its first three lanes.
HWY_INLINE FourPairs sums(const FourPairs& a, const FourPairs& b, const FourPairs& c, const FourPairs& d) {
  const Columns hi = transposed(a.hi, b.hi, c.hi, d.hi), lo = transposed(a.lo, b.lo, c.lo, d.lo);
  return sum(sum({hi.first, lo.first}, {hi.second, lo.second}), {hi.third, lo.third});
}
HWY_INLINE FourLanes sums(FourLanes a, FourLanes b, FourLanes c, FourLanes d) {
  const Columns columns = transposed(a, b, c, d);
  return hn::Add(hn::Add(columns.first, columns.second), columns.third);
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
/// A vector of the ray's, and the number after it, which nothing depends on.
template <Real T>
HWY_INLINE FourLanes vector(const Vec3<T>& v) {
  static_assert(offsetof(Ray<T>, t_min) == 6 * sizeof(T));
  return load_as_double(Four(), &v.x);
}
template <Real T>
HWY_INLINE FourLanes corner(const TriangleBlock<T>& block, int lane, int c) {
  const Vec3<T> p = block.corner(c, lane);
  return set(p.x, p.y, p.z);
}

HWY_INLINE FourLanes last_in_all(FourLanes v) {
  const Four f;
  const FourLanes upper = hn::ConcatUpperUpper(f, v, v);
  return hn::InterleaveUpper(f, upper, upper);
}

/// t, u, v as hi + lo, rounded, with errors as of rounding::with_errors; false where they are not certain, as
/// rounding::round_certainly.
template <Real T>
HWY_INLINE bool round_lanes(FourLanes hi, FourLanes lo, FourLanes determinant, const rounding::FaceBounds& bounds,
                            double relative, double division, TriangleHit<T>& hit) {
  constexpr bool is_float = sizeof(T) < sizeof(double);
  const Four f;
  const hn::Rebind<T, Four> out;
  const auto set_all = [f](double x) HWY_ATTR { return hn::Set(f, x); };
  const auto rounded = [out](FourLanes v) HWY_ATTR {
    if constexpr (is_float) {
      return hn::DemoteTo(out, v);
    } else {
      return v;
    }
  };
  const FourLanes size = hn::Abs(hi), whole = hn::Abs(determinant);
  const FourLanes n_error = hn::IfThenElse(hn::FirstN(f, 1), set_all(bounds.distance_error), set_all(bounds.error));
  const FourLanes scale = hn::Div(set_all((1 + rounding::second_order) * relative), whole);
  const FourLanes error = hn::MulAdd(hn::MulAdd(size, set_all(bounds.error), n_error), scale, hn::Mul(size, set_all(division)));
  const FourLanes slack = hn::Mul(size, set_all(is_float ? rounding::float_sum_error : 0));
  const FourLanes margin = hn::MulAdd(error, set_all(1 + rounding::margin_share), slack);
  const auto below = rounded(hn::Add(hi, hn::Sub(lo, margin))), above = rounded(hn::Add(hi, hn::Add(lo, margin)));
  const auto is_bounded = hn::Gt(whole, set_all(rounding::certainty * relative * bounds.error));
  const auto is_ordinary =
      hn::And(hn::Gt(size, set_all(is_float ? 0x1p-125 : 0x1p-900)), hn::Lt(size, set_all(is_float ? 0x1p126 : 0x1p900)));
  const unsigned certain = bits_of_mask(out, hn::Eq(below, above)) & bits_of_mask(f, hn::And(is_ordinary, is_bounded));
  alignas(32) T numbers[4];
  hn::Store(below, out, numbers);
  hit.t = hit.t_end = numbers[0];
  hit.u = numbers[1];
  hit.v = numbers[2];
  hit.kind = TriangleKind::face;
  hit.facing = bounds.is_front ? Facing::front : Facing::back;
  return (certain & 7) == 7;
}

/// t, u, v of a block's triangle in whose face the ray is known to hit it, from determinants in double-double; false where they
/// are not certain.
HWY_INLINE bool round_face(const Ray<double>& ray, const TriangleBlock<double>& block, int lane,
                           const rounding::FaceBounds& bounds, TriangleHit<double>& hit) {
  const FourLanes a = corner(block, lane, 0), d = vector(ray.direction);
  const FourPairs e1 = two_difference(corner(block, lane, 1), a), e2 = two_difference(corner(block, lane, 2), a);
  const FourPairs t = two_difference(vector(ray.origin), a), h = cross(d, e2), g = cross(t, e1);
  // The distance, u, v and the determinant.
  const FourPairs unnormalised = sums(product(e2, g), product(t, h), product(d, g), product(e1, h));
  const FourPairs n = two_sum(unnormalised.hi, unnormalised.lo);
  const FourPairs determinant{last_in_all(n.hi), last_in_all(n.lo)};
  const FourLanes q = hn::Div(n.hi, determinant.hi);
  const FourPairs p = product(q, determinant.hi);
  const FourLanes rest = hn::Add(hn::Sub(hn::Sub(n.hi, p.hi), p.lo), hn::Sub(n.lo, hn::Mul(q, determinant.lo)));
  return round_lanes(q, hn::Div(rest, determinant.hi), determinant.hi, bounds, rounding::pair_relative,
                     rounding::pair_quotient_error, hit);
}

HWY_INLINE FourLanes cross(FourLanes a, FourLanes b) {
  return rotated(hn::MulSub(a, rotated(b), hn::Mul(rotated(a), b)));
}

/// The same for float, from determinants in double.
HWY_INLINE bool round_face(const Ray<float>& ray, const TriangleBlock<float>& block, int lane,
                           const rounding::FaceBounds& bounds, TriangleHit<float>& hit) {
  const FourLanes a = corner(block, lane, 0), d = vector(ray.direction);
  const FourLanes e1 = hn::Sub(corner(block, lane, 1), a), e2 = hn::Sub(corner(block, lane, 2), a);
  const FourLanes t = hn::Sub(vector(ray.origin), a), h = cross(d, e2), g = cross(t, e1);
  const FourLanes n = sums(hn::Mul(e2, g), hn::Mul(t, h), hn::Mul(d, g), hn::Mul(e1, h)), determinant = last_in_all(n);
  return round_lanes(hn::Div(n, determinant), hn::Zero(Four()), determinant, bounds, 1, rounding::quotient_error, hit);
}

template <Real T>
HWY_NOINLINE void exact_face(const Ray<T>& ray, const TriangleBlock<T>& block, int lane, TriangleHit<T>& hit) noexcept {
  hit = exact::intersect(ray, block.triangle(lane));
}

template <Real T>
HWY_NOINLINE HWY_FLATTEN void face(const Ray<T>& ray, const TriangleBlock<T>& block, int lane,
                                   const rounding::FaceBounds& bounds, TriangleHit<T>& hit) noexcept {
  if (HWY_LIKELY(numeric::rounds_to_nearest() && round_face(ray, block, lane, bounds, hit))) return;
  exact_face(ray, block, lane, hit);
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
