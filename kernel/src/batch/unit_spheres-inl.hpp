// One ray without upper end against many spheres, decisions alone, in rounding to nearest. With the direction d as long as 1, L
// = c - e:
//   B = d.L,  C = L.L - r^2,  D = B^2 - C
// 12 operations and no division; the ray's share is computed once.
#if defined(GRAZE_BATCH_UNIT_SPHERES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_UNIT_SPHERES_INL_HPP
#undef GRAZE_BATCH_UNIT_SPHERES_INL_HPP
#else
#define GRAZE_BATCH_UNIT_SPHERES_INL_HPP
#endif

#include "batch/bounds.hpp"
#include "batch/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

/// The bounds, in rounding to nearest. Write v for half of `unit`, S for L.L + r^2, and A, b for the given direction's d.d and
/// d.L, so that B stands for b / sqrt(A) and D for (b^2 - A C) / A.
///  - The length errs by 2.5 v of itself: half of what A does, and the root; each component by v more.
///  - B: monomials of 4 roundings and that one, together at most |L|, and the length: 7.5 v |L|; so B^2 by 15 v L.L and v.
///  - C: 6 v S (sphere_filter.hpp), and the last difference 2 v S: 24 v S in all for D. unit_sphere_error, 32 v S, is taken,
///  for C
///    too: kernel/proofs/batch_spheres.g.
/// What underflows, with f for `flushed`: as in spheres-inl.hpp for A = 1, that is 2^-20 of 4 v S, or 2^21 f holds it. What
/// overflows, or is NaN, makes the bound infinite or NaN, and nothing exceeds it.
/// Where D and C are both beyond the bound and above zero, |B| > sqrt(C) > 5 sqrt(v) |L|: its computed sign is right.
template <class D, Doubt doubt>
class UnitSpheres {
 public:
  using T = hn::TFromD<D>;
  using V = Lanes<D>;

  HWY_INLINE UnitSpheres(D d, const UnitRay<T>& ray)
      : origin_{hn::Set(d, ray.origin[0]), hn::Set(d, ray.origin[1]), hn::Set(d, ray.origin[2])},
        direction_{hn::Set(d, ray.direction[0]), hn::Set(d, ray.direction[1]), hn::Set(d, ray.direction[2])},
        settled_(hn::SignBit(d)) {}

  HWY_INLINE void begin_word() requires(doubt == Doubt::of_words) { settled_ = hn::SignBit(D()); }
  HWY_INLINE bool is_sure() const requires(doubt == Doubt::of_words) { return hn::AllTrue(D(), sign_mask(D(), settled_)); }

  template <class Rays, class Spheres>
  HWY_INLINE WordVerdict operator()(const Rays&, const Spheres& spheres, std::size_t i) {
    const D d;
    // L and B negated: what is subtracted is read from memory by the subtraction itself.
    const Vector3<D> l = origin_ - spheres.vector(0, i);
    const V r = spheres.get(3, i), r2 = hn::Mul(r, r), b = dot<D>(direction_, l);
    const V c = hn::MulAdd(l.x, l.x, hn::MulAdd(l.y, l.y, hn::MulSub(l.z, l.z, r2))), discriminant = hn::MulSub(b, b, c);
    // S = C + 2 r^2.
    const V error = hn::MulAdd(c, hn::Set(d, bound), hn::MulAdd(r2, hn::Set(d, 2 * bound), hn::Set(d, flushed)));
    const auto is_certain = hn::Gt(hn::Min(hn::Abs(discriminant), hn::Abs(c)), error);
    // Roots, and inside or ahead; or no root, or behind.
    const V is_hit = hn::AndNot(discriminant, hn::Or(c, b));
    // A radius with its sign bit set settles nothing.
    if constexpr (doubt == Doubt::of_words) {
      settled_ = hn::And(settled_, hn::AndNot(r, hn::VecFromMask(d, is_certain)));
      return {bits(d, sign_mask(d, is_hit)), 0, 0};
    } else {
      const auto settled = hn::AndNot(sign_mask(d, r), is_certain);
      return {bits(d, sign_mask(d, is_hit)), bits(d, settled), 0};
    }
  }

 private:
  static constexpr T bound = T(unit_sphere_error) * Bounds<T>::unit, flushed = T(0x1p21) * Bounds<T>::flushed;

  Vector3<D> origin_, direction_;
  V settled_;
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
