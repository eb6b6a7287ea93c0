// Rays and triangles in lanes, in the inputs' own format, arrays or one on either side: Moeller and Trumbore's determinants
// with bounds of their errors, as in predicates/triangle_filter.hpp.
#if defined(GRAZE_BATCH_TRIANGLES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_TRIANGLES_INL_HPP
#undef GRAZE_BATCH_TRIANGLES_INL_HPP
#else
#define GRAZE_BATCH_TRIANGLES_INL_HPP
#endif

#include <limits>

#include "batch/bounds.hpp"
#include "batch/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

template <class D>
HWY_INLINE LaneMask<D> is_infinite(D d, Lanes<D> x) {
  return hn::Eq(x, hn::Set(d, std::numeric_limits<hn::TFromD<D>>::infinity()));
}

/// Which ranges may be trusted: t_min < t_max, which also tells of flushed numbers truly, and both of a size that no product
/// overflows with, or t_max infinite. Equal bounds are left in doubt.
template <class D>
HWY_INLINE LaneMask<D> range_is_valid(D d, Lanes<D> t_min, Lanes<D> t_max) {
  const Lanes<D> high = hn::Set(d, Bounds<hn::TFromD<D>>::high);
  const auto is_bounded = hn::Or(hn::Le(t_max, high), is_infinite(d, t_max));
  return hn::And(hn::Lt(t_min, t_max), hn::And(is_bounded, hn::Le(hn::Abs(t_min), high)));
}

/// determinant = E1.H, u = T.H, v = d.G, distance = E2.G with E1 = b - a, E2 = c - a, T = e - a, H = d x E2, G = T x E1. Each
/// is a sum of six monomials in components of three vectors, together at most m, the product of their sums of magnitudes. A
/// monomial is rounded at most 5 times, and two of its factors are rounded differences, of `distance` all three: 8 roundings.
/// determinant_error u m as computed holds them, u being the format's unit. w = whole - u - v is rounded twice more, and so is
/// distance - t whole: combination_share of the bounds' sum holds that.
/// Vectors lie in [low, high]: a product of three is at least low^3, so what underflows, or is read as zero, is 2^-25 u of the
/// bound, and nothing overflows.
/// Where a bound of the range is so small that its product underflows, or that it is read as zero, the error is far below the
/// bound of the distance. Proof: kernel/proofs/batch_triangles.g.
template <class D, bool has_range>
struct TriangleFilter {
  template <class Rays, class Triangles>
  HWY_INLINE WordVerdict operator()(const Rays& rays, const Triangles& triangles, std::size_t i) const {
    using T = hn::TFromD<D>;
    using V = Lanes<D>;
    const D d;
    const Vector3<D> a = triangles.vector(0, i), direction = rays.vector(3, i);
    const Vector3<D> e1 = triangles.vector(3, i) - a, e2 = triangles.vector(6, i) - a, from_a = rays.vector(0, i) - a;
    const Vector3<D> h = cross<D>(direction, e2), g = cross<D>(from_a, e1);
    const V determinant = dot<D>(e1, h);
    const V nd = magnitude_sum<D>(direction), n1 = magnitude_sum<D>(e1), n2 = magnitude_sum<D>(e2),
            nt = magnitude_sum<D>(from_a);
    const V unit = hn::Set(d, T(determinant_error) * Bounds<T>::unit), k2 = hn::Mul(unit, n2), k1 = hn::Mul(unit, n1),
            dt = hn::Mul(nd, nt);
    const V whole_error = hn::Mul(k2, hn::Mul(nd, n1)), u_error = hn::Mul(k2, dt), v_error = hn::Mul(k1, dt),
            distance_error = hn::Mul(k2, hn::Mul(nt, n1));
    // A sum, not a maximum, against `high`: it is NaN where one of them is.
    const auto is_ordinary = hn::And(hn::Ge(hn::Min(hn::Min(nd, nt), hn::Min(n1, n2)), hn::Set(d, Bounds<T>::low)),
                                     hn::Le(hn::Add(hn::Add(nd, nt), hn::Add(n1, n2)), hn::Set(d, Bounds<T>::high)));
    const V sign = hn::And(determinant, hn::SignBit(d)), whole = hn::Abs(determinant);
    auto is_certain = hn::And(is_ordinary, hn::Gt(whole, whole_error));
    const V u = hn::Xor(dot<D>(from_a, h), sign), v = hn::Xor(dot<D>(direction, g), sign),
            distance = hn::Xor(dot<D>(e2, g), sign);
    const V w = hn::Sub(hn::Sub(whole, u), v);
    const V w_error = hn::Mul(hn::Set(d, T(combination_share)), hn::Add(hn::Add(whole_error, u_error), v_error));

    // Each beyond its error below or above zero: out where one is below, in where all are above.
    auto is_below = hn::Or(hn::Or(hn::Lt(u, hn::Neg(u_error)), hn::Lt(v, hn::Neg(v_error))), hn::Lt(w, hn::Neg(w_error)));
    auto is_above = hn::And(hn::And(hn::Gt(u, u_error), hn::Gt(v, v_error)), hn::Gt(w, w_error));
    const auto include = [&](V value, V error) {
      is_below = hn::Or(is_below, hn::Lt(value, hn::Neg(error)));
      is_above = hn::And(is_above, hn::Gt(value, error));
    };
    if constexpr (has_range) {
      const V t_min = rays.get(6, i), t_max = rays.get(7, i);
      is_certain = hn::And(is_certain, range_is_valid(d, t_min, t_max));
      const auto bound_error = [&](V x) {
        return hn::Mul(hn::Set(d, T(combination_share)), hn::MulAdd(hn::Abs(x), whole_error, distance_error));
      };
      include(hn::NegMulAdd(t_min, whole, distance), bound_error(t_min));
      // Without an upper end that side is as far as one likes.
      const auto endless = is_infinite(d, t_max);
      const V to_end = hn::IfThenElse(endless, whole, hn::MulSub(t_max, whole, distance));
      include(to_end, hn::IfThenElse(endless, hn::Zero(d), bound_error(t_max)));
    } else {
      include(distance, distance_error);
    }
    const auto hit = hn::And(is_certain, is_above), miss = hn::And(is_certain, is_below);
    // Front where d.n < 0, and the determinant is -d.n.
    return {bits(d, hit), bits(d, hn::Or(hit, miss)), bits(d, hn::Not(sign_mask(d, determinant)))};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
