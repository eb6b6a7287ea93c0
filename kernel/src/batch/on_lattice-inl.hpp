// Rays and shapes in lanes of double that lie on lattices of few steps: decisions without any error, for what the filters leave
// in doubt. In rounding to nearest, with subnormal numbers, for rays without upper end from t = 0.
#if defined(GRAZE_BATCH_ON_LATTICE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_ON_LATTICE_INL_HPP
#undef GRAZE_BATCH_ON_LATTICE_INL_HPP
#else
#define GRAZE_BATCH_ON_LATTICE_INL_HPP
#endif

#include <algorithm>
#include <bit>

#include "batch/bounds.hpp"
#include "batch/lanes-inl.hpp"
#include "graze/numeric/filter.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE Lanes<D> greatest(const Vector3<D>& v) {
  return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// numeric::Lattice (numeric/lattice.hpp) in lanes. Of a greatest magnitude m the step is above 2^-54 2^28 m: m is below 2^26
/// steps.
template <class D>
class LatticeLanes {
 public:
  using V = Lanes<D>;

  HWY_INLINE explicit LatticeLanes(V most) : size_(hn::Mul(most, hn::Set(D(), fineness))), off_(hn::Zero(D())) {}

  HWY_INLINE void include(V x) { off_ = hn::Or(off_, hn::Xor(x, hn::Sub(hn::Add(x, size_), size_))); }
  HWY_INLINE void include(const Vector3<D>& v) { include(v.x), include(v.y), include(v.z); }

  /// Also that the sizes are ordinary, and at most `greatest`.
  HWY_INLINE LaneMask<D> holds_all(V greatest = hn::Set(D(), Bounds<double>::high)) const {
    const D d;
    const hn::RebindToUnsigned<D> du;
    const auto is_off = hn::Ne(hn::BitCast(du, hn::Abs(off_)), hn::Zero(du));
    const auto is_ordinary = hn::And(hn::Ge(size_, hn::Set(d, Bounds<double>::low)), hn::Le(size_, greatest));
    return hn::AndNot(hn::RebindMask(d, is_off), is_ordinary);
  }

 private:
  static constexpr double fineness = 0x1p28;

  V size_, off_;
};

/// The greatest size, of those that are ordinary, on whose lattice x, y and z are. A size in [2^k, 2^(k+1)) has steps of
/// 2^(k-53), and the number's last bit is to be no less.
HWY_INLINE double greatest_size(double x, double y, double z) {
  double greatest = Bounds<double>::high;
  for (const double v : {x, y, z}) {
    const std::uint64_t all = numeric::magnitude_bits(v), above = all & (all - 1), mantissa = (std::uint64_t(1) << 52) - 1;
    if (all == 0) continue;
    const double magnitude = std::bit_cast<double>(all);
    const double last = (all & mantissa) == 0 ? magnitude : magnitude - std::bit_cast<double>(above);
    greatest = std::min(greatest, last * 0x1p53);
  }
  return greatest;
}

/// That of the one ray's origin. Of many rays each lane looks itself.
template <class D, int m>
HWY_INLINE Lanes<D> greatest_position(const Run<double, m>& run) {
  const auto& ray = run.rays.column;
  return hn::Set(D(), run.has_many_rays ? Bounds<double>::high : greatest_size(*ray[0], *ray[1], *ray[2]));
}

/// hi + lo. In steps, lo is an integer far below 2^53 in all that follows: sums of such are without error, and so is the sign
/// of hi + lo as rounded.
template <class D>
struct LanePair {
  Lanes<D> hi, lo;

  HWY_INLINE Lanes<D> sum() const { return hn::Add(hi, lo); }
};

template <class D>
HWY_INLINE LanePair<D> operator+(const LanePair<D>& a, const LanePair<D>& b) {
  const Lanes<D> s = hn::Add(a.hi, b.hi), bb = hn::Sub(s, a.hi);
  const Lanes<D> rest = hn::Add(hn::Sub(a.hi, hn::Sub(s, bb)), hn::Sub(b.hi, bb));
  return {s, hn::Add(rest, hn::Add(a.lo, b.lo))};
}
template <class D>
HWY_INLINE LanePair<D> operator-(const LanePair<D>& a, const LanePair<D>& b) {
  return a + LanePair<D>{hn::Neg(b.hi), hn::Neg(b.lo)};
}

/// a b without error, where the machine rounds a multiply-add once.
template <class D>
HWY_INLINE LanePair<D> pair_product(Lanes<D> a, Lanes<D> b) {
  const Lanes<D> p = hn::Mul(a, b);
  return {p, hn::MulSub(a, b, p)};
}
template <class D>
HWY_INLINE LanePair<D> pair_dot(const Vector3<D>& a, const Vector3<D>& b) {
  return pair_product<D>(a.x, b.x) + pair_product<D>(a.y, b.y) + pair_product<D>(a.z, b.z);
}

template <class D>
HWY_INLINE LaneMask<D> is_number(Lanes<D> v) {
  return hn::Eq(v, v);
}

/// The determinants of triangles-inl.hpp. In steps, components of E1, E2, T and d are below 2^26, of H and G at most 2^53:
/// doubles; products of both below 2^79, their low parts at most 2^25, and all sums of these below 2^30. A NaN anywhere makes
/// whole or u one.
/// A ray in the triangle's plane, or beside it, is left in doubt.
template <class D, bool has_range>
class TrianglesOnLattice {
  static_assert(!has_range);

 public:
  HWY_INLINE explicit TrianglesOnLattice(const Run<double, 9>& run) : greatest_(greatest_position<D>(run)) {}

  template <class Rays, class Triangles>
  HWY_INLINE WordVerdict operator()(const Rays& rays, const Triangles& triangles, std::size_t i) const {
    using V = Lanes<D>;
    const D d;
    const Vector3<D> e = rays.vector(0, i), direction = rays.vector(3, i);
    const Vector3<D> a = triangles.vector(0, i), b = triangles.vector(3, i), c = triangles.vector(6, i);
    const Vector3<D> e1 = b - a, e2 = c - a, t = e - a;
    LatticeLanes<D> positions(hn::Max(greatest<D>(e1), hn::Max(greatest<D>(e2), greatest<D>(t))));
    positions.include(a), positions.include(b), positions.include(c);
    if constexpr (Rays::is_many) positions.include(e);
    LatticeLanes<D> directions(greatest<D>(direction));
    directions.include(direction);
    const auto is_exact = hn::And(positions.holds_all(greatest_), directions.holds_all());
    const Vector3<D> h = cross<D>(direction, e2), g = cross<D>(t, e1);
    const LanePair<D> whole = pair_dot<D>(e1, h), u = pair_dot<D>(t, h), v = pair_dot<D>(direction, g),
                      distance = pair_dot<D>(e2, g), w = whole - u - v;
    const V determinant = whole.sum(), sign = hn::And(determinant, hn::SignBit(d)), zero = hn::Zero(d);
    const V least = hn::Min(hn::Min(hn::Xor(u.sum(), sign), hn::Xor(v.sum(), sign)),
                            hn::Min(hn::Xor(w.sum(), sign), hn::Xor(distance.sum(), sign)));
    const auto is_told = hn::And(hn::And(is_exact, hn::Ne(determinant, zero)), is_number<D>(hn::Add(determinant, u.hi)));
    return {bits(d, hn::And(is_told, hn::Ge(least, zero))), bits(d, is_told), 0};
  }

 private:
  Lanes<D> greatest_;
};

/// The coefficients of spheres-inl.hpp. In steps, components of L and d, and r, are below 2^25, for twice their size is taken:
/// A, B, and L.L + r^2 at most 2^52. B^2 and A C are pairs without error; rounding is monotone, so where their high parts
/// differ, they do. A NaN anywhere makes B or C one. With its sign bit set a radius is left in doubt.
template <class D, bool has_range>
class SpheresOnLattice {
  static_assert(!has_range);

 public:
  HWY_INLINE explicit SpheresOnLattice(const Run<double, 4>& run) : greatest_(greatest_position<D>(run)) {}

  template <class Rays, class Spheres>
  HWY_INLINE WordVerdict operator()(const Rays& rays, const Spheres& spheres, std::size_t i) const {
    using V = Lanes<D>;
    const D d;
    const Vector3<D> e = rays.vector(0, i), direction = rays.vector(3, i), center = spheres.vector(0, i), l = center - e;
    const V r = spheres.get(3, i), two = hn::Set(d, 2);
    LatticeLanes<D> positions(hn::Mul(two, hn::Max(greatest<D>(l), r))), directions(hn::Mul(two, greatest<D>(direction)));
    positions.include(center), positions.include(r);
    directions.include(direction);
    if constexpr (Rays::is_many) positions.include(e);
    const V a = dot<D>(direction, direction), b = dot<D>(direction, l), c = hn::NegMulAdd(r, r, dot<D>(l, l)),
            zero = hn::Zero(d);
    const LanePair<D> bb = pair_product<D>(b, b), ac = pair_product<D>(a, c);
    const auto has_root = hn::Or(hn::Gt(bb.hi, ac.hi), hn::And(hn::Eq(bb.hi, ac.hi), hn::Ge(bb.lo, ac.lo)));
    const auto is_ahead = hn::Or(hn::Ge(b, zero), hn::Le(c, zero));
    const auto is_exact = hn::And(positions.holds_all(greatest_), directions.holds_all());
    const auto is_told = hn::AndNot(sign_mask(d, r), hn::And(is_exact, is_number<D>(hn::Add(b, c))));
    return {bits(d, hn::And(is_told, hn::And(has_root, is_ahead))), bits(d, is_told), 0};
  }

 private:
  Lanes<D> greatest_;
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
