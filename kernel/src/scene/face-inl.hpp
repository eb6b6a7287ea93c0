// Per target: rounding/face.cpp in double on four lanes with FMA, where the target has both; elsewhere that itself. Included
// anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_FACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_FACE_INL
#undef GRAZE_SCENE_FACE_INL
#else
#define GRAZE_SCENE_FACE_INL
#endif

#include "rounding/quotients.hpp"

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

HWY_INLINE FourLanes four(const Vec3<double>& v) {
  alignas(32) const double lanes[4] = {v.x, v.y, v.z, 0};
  return hn::Load(Four(), lanes);
}

HWY_NOINLINE HWY_FLATTEN TriangleHit<double> face(const Ray<double>& ray, const Triangle<double>& triangle,
                                                  const predicates::TriangleTerms<double>& terms) noexcept {
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, triangle);
  const FourLanes a = four(triangle.a), d = four(ray.direction);
  const FourPairs e1 = two_difference(four(triangle.b), a), e2 = two_difference(four(triangle.c), a);
  const FourPairs t = two_difference(four(ray.origin), a), h = cross(d, e2), g = cross(t, e1);
  const FourPairs unnormalised = sums(product(e2, g), product(t, h), product(d, g), product(e1, h));
  const FourPairs n = two_sum(unnormalised.hi, unnormalised.lo);
  alignas(32) double hi[4], lo[4];
  hn::Store(n.hi, Four(), hi);
  hn::Store(n.lo, Four(), lo);
  const double determinant = hi[3];
  const FourLanes d_hi = hn::Set(Four(), hi[3]), d_lo = hn::Set(Four(), lo[3]), q = hn::Div(n.hi, d_hi);
  const FourPairs p = product(q, d_hi);
  const FourLanes rest = hn::Add(hn::Sub(hn::Sub(n.hi, p.hi), p.lo), hn::Sub(n.lo, hn::Mul(q, d_lo)));
  hn::Store(q, Four(), hi);
  hn::Store(hn::Div(rest, d_hi), Four(), lo);
  using numeric::Lanes;
  TriangleHit<double> hit;
  const rounding::Quotients quotients =
      rounding::with_pair_errors(Lanes{hi[0], hi[1], hi[2], 0}, Lanes{lo[0], lo[1], lo[2], 0}, determinant, terms);
  return rounding::round_certainly(quotients, terms, hit) ? hit : exact::intersect(ray, triangle);
}

#else

TriangleHit<double> face(const Ray<double>& ray, const Triangle<double>& triangle,
                         const predicates::TriangleTerms<double>& terms) noexcept {
  return rounding::face(ray, triangle, terms);
}

#endif

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
