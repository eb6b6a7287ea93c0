// Rays and spheres in lanes: predicates/sphere_filter.hpp in the input's own format, arrays or one on either side.
#if defined(GRAZE_BATCH_SPHERES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_SPHERES_INL_HPP
#undef GRAZE_BATCH_SPHERES_INL_HPP
#else
#define GRAZE_BATCH_SPHERES_INL_HPP
#endif

#include "batch/bounds.hpp"
#include "batch/lanes-inl.hpp"
#include "batch/triangles-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

/// With L = c - e: A = d.d, B = d.L, C = L.L - r^2, D = B^2 - A C. C errs by sphere_c_error u S and D by
/// sphere_discriminant_error u A S, with S = L.L + r^2 and u the format's unit, each of which is asked to be such that A S does
/// not overflow.
/// What underflows, with f for `flushed` and |d| in [low, high]: L.L errs by 4 f |L| and 2 f more, B by 4 f (|d| + 1), and so D
/// by 2^4 f (A + 1) (1 + |L|) (|d||L| + 1) more. Where |L| is above 2^-16 (in double, 2^-190), that is 2^-20 of 8 u A S; where
/// it is below, 2^20 f (A + 1) holds D's and 2^20 f holds C's. With C > 0 beyond its bound B^2 > A C > 0 where D > 0: the
/// computed sign of B is right. Proof: kernel/proofs/batch_spheres.g.
template <class D, bool has_range>
struct SphereFilter {
  using T = hn::TFromD<D>;
  using V = Lanes<D>;
  /// 2^20 f in half the bound's units, for the bound is computed of 2 A.
  static constexpr T scale = 2 / (T(sphere_discriminant_error) * Bounds<T>::unit),
                     flushed = T(0x1p20) * Bounds<T>::flushed * scale;
  static constexpr T place_scale = 1 / (T(sphere_place_error) * Bounds<T>::unit);

  template <class Rays, class Spheres>
  HWY_INLINE WordVerdict operator()(const Rays& rays, const Spheres& spheres, std::size_t i) const {
    const D d;
    const Vector3<D> direction = rays.vector(3, i), l = spheres.vector(0, i) - rays.vector(0, i);
    const V r = spheres.get(3, i), r2 = hn::Mul(r, r), l2 = dot<D>(l, l);
    const V a = dot<D>(direction, direction), b = dot<D>(direction, l), c = hn::Sub(l2, r2), c_size = hn::Add(l2, r2);
    const V discriminant = hn::MulSub(b, b, hn::Mul(a, c));
    const V slack = hn::MulAdd(a, hn::Set(d, flushed), hn::Set(d, flushed));
    const V discriminant_size = hn::MulAdd(hn::Add(a, a), c_size, slack);
    const auto a_is_ordinary = hn::And(hn::Ge(a, hn::Set(d, Bounds<T>::low * Bounds<T>::low)),
                                       hn::Le(a, hn::Set(d, Bounds<T>::high * Bounds<T>::high)));
    // A radius with its sign bit set makes this negative.
    const V magnitude = hn::CopySignToAbs(hn::Abs(discriminant), r);
    const auto is_ordinary = hn::And(a_is_ordinary, hn::Le(c_size, hn::Set(d, Bounds<T>::most_squares)));
    const auto d_is_certain = hn::And(is_ordinary, hn::Gt(hn::Mul(magnitude, hn::Set(d, scale)), discriminant_size));
    const auto c_is_certain =
        hn::Gt(hn::Abs(c), hn::MulAdd(hn::Set(d, T(sphere_c_error) * Bounds<T>::unit), c_size, hn::Set(d, flushed)));
    const auto no_root = sign_mask(d, discriminant);
    const std::uint64_t inside = bits(d, sign_mask(d, hn::AndNot(discriminant, c)));
    if constexpr (has_range) {
      const V t_min = rays.get(6, i), t_max = rays.get(7, i);
      const auto is_valid = hn::And(d_is_certain, range_is_valid(d, t_min, t_max));
      const V b_size = hn::Sqrt(hn::Mul(a, c_size));
      const Place from = place_of(t_min, a, b, c, b_size, c_size, slack), to = place_of(t_max, a, b, c, b_size, c_size, slack);
      const auto endless = is_infinite(d, t_max);
      const auto to_after = hn::Or(endless, to.after), to_before = hn::AndNot(endless, to.before),
                 to_between = hn::AndNot(endless, to.between);
      const auto hit_first = hn::And(from.before, hn::Or(to_between, to_after));
      const auto hit_second = hn::And(hn::Or(from.before, from.between), to_after);
      const auto hit = hn::AndNot(no_root, hn::And(is_valid, hn::Or(hit_first, hit_second)));
      const auto past = hn::Or(from.after, hn::Or(to_before, hn::And(from.between, to_between)));
      // The origin's side is told of misses too, so C is to be certain unless there is no root.
      const auto miss = hn::And(is_valid, hn::Or(no_root, hn::And(c_is_certain, past)));
      return {bits(d, hit), bits(d, hn::Or(hit, miss)), inside};
    } else {
      const auto settled = hn::And(d_is_certain, hn::Or(no_root, c_is_certain));
      // Behind: outside, and B < 0.
      const auto is_miss = sign_mask(d, hn::Or(discriminant, hn::AndNot(c, b)));
      return {bits(d, hn::AndNot(is_miss, settled)), bits(d, settled), inside};
    }
  }

 private:
  /// Where a number lies against both roots, as far as that is certain.
  struct Place {
    LaneMask<D> before, between, after;
  };

  /// By the signs of f = A x^2 - 2 B x + C and g = A x - B, with sphere_place_error u of the sums of
  /// magnitudes, and 2^20 f (A + 1) (1 + |x|) for what underflows. An x that is too small to be ordinary,
  /// but zero, is left in doubt.
  static HWY_INLINE Place place_of(V x, V a, V b, V c, V b_size, V c_size, V discriminant_slack) {
    const D d;
    const V ax = hn::Mul(a, x), bb = hn::Add(b, b), s = hn::Set(d, place_scale);
    const V slack = hn::Mul(discriminant_slack, hn::Set(d, place_scale / scale));
    const V g = hn::Mul(hn::Sub(ax, b), s), f = hn::Mul(hn::MulAdd(hn::Sub(ax, bb), x, c), s);
    const V size = hn::Abs(x), ax_size = hn::Mul(a, size);
    const V g_size = hn::Add(hn::Add(ax_size, b_size), slack);
    const V f_size = hn::MulAdd(hn::Add(hn::Add(ax_size, hn::Add(b_size, b_size)), slack), size, hn::Add(c_size, slack));
    const auto is_ordinary = hn::Or(
        hn::And(hn::Ge(size, hn::Set(d, Bounds<T>::low)), hn::Le(size, hn::Set(d, Bounds<T>::high))), hn::Eq(x, hn::Zero(d)));
    const auto outer = hn::And(is_ordinary, hn::Gt(f, f_size));
    return {hn::And(outer, hn::Lt(g, hn::Neg(g_size))), hn::And(is_ordinary, hn::Lt(f, hn::Neg(f_size))),
            hn::And(outer, hn::Gt(g, g_size))};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
