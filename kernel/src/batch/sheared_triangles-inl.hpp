// One ray against many triangles, decisions alone. With A, B, C the corners relative to the origin, and z the axis of the
// direction's longest component, x' = x - (dx / dz) z and y' = y - (dy / dz) z lay the ray along z (Woop, Benthin, Wald 2013):
//   U = C'x B'y - C'y B'x,  V = A'x C'y - A'y C'x,  W = B'x A'y - B'y A'x   the corners' weights, times U + V + W
//   T = U Az + V Bz + W Cz = t dz (U + V + W)
// 15 products a triangle and no division; the ray's share is computed once.
#if defined(GRAZE_BATCH_SHEARED_TRIANGLES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_SHEARED_TRIANGLES_INL_HPP
#undef GRAZE_BATCH_SHEARED_TRIANGLES_INL_HPP
#else
#define GRAZE_BATCH_SHEARED_TRIANGLES_INL_HPP
#endif

#include "batch/bounds.hpp"
#include "batch/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

/// The bounds. Write u for `unit`, q_A for A'x^2 + A'y^2 and so on, z for Az^2 + Bz^2 + Cz^2, Q for q_A + q_B + q_C + z, and Z
/// for |Az| + |Bz| + |Cz| <= sqrt(3 z).
///  - A'x: the difference and the slope (at most 1) err by u of themselves, the product and the sum by u again: at most u |Ax|
///  +
///    3 u |Az| + u |A'x| <= 2 u |A'x| + 4 u |Az|.
///  - U: 2 u (|C'x B'y| + |C'y B'x|) by rounding and, of the factors' errors, twice as much and 4 u ((|C'x| + |C'y|) |Bz| +
///    (|B'x| + |B'y|) |Cz|). By 2 a b <= a^2 + b^2 that is 5.9 u (q_B + q_C) + 2.9 u (Bz^2 + Cz^2): 6 u Q.
///  - T: |U| <= (q_B + q_C) / 2. Each term passes 4 roundings and the error of its weight: (5.9 + 2) u Q Z = 8 u Q Z.
///  - U + V + W: every q twice, and two roundings: 14 u Q. With a bound x dz = X of the range, T - X (U + V + W) errs by
///    8 u Q Z, 14 u Q |X|, 2 u Q |X| for X and the product, and u (Q Z / 2 + Q |X|) for the difference: 9 u Q (Z + 2 |X|).
/// So E = sheared_error u Q does for the weights. For the distance, squared to save the root, E^2 z >= (9 u Q Z)^2, and with a
/// bound X of the range E^2 (2 z + 3 X^2) >= (9 u Q (Z + 2 |X|))^2 by (x + y)^2 <= 2 x^2 + 2 y^2, with a twentieth to spare for
/// a dozen roundings of their own. Proof: kernel/proofs/batch_sheared.g.
///
/// What underflows: with f for `flushed`, U errs by 60 f (1 + Q) more and T by 4 f Q, 200 f (1 + Q) Z and 6 f. With z at least
/// `least_z`, E holds the first, and E sqrt(z) what of T's goes with Q; 6 f and 200 f Z are in `least_square` (where Z is
/// large, Q is). Squares that are flushed lose less than 2^-5 of that. Q and |X| are asked to be such that T, X (U + V + W) and
/// E^2 do not overflow; of their squares only the sizes count. A NaN or an infinity in a corner makes Q one, or the largest
/// number.
template <class D, bool has_least, bool has_most>
class ShearedTriangles {
 public:
  using T = hn::TFromD<D>;
  using V = Lanes<D>;

  HWY_INLINE ShearedTriangles(D d, const ShearedRay<T>& ray)
      : ox_(hn::Set(d, ray.origin[0])),
        oy_(hn::Set(d, ray.origin[1])),
        oz_(hn::Set(d, ray.origin[2])),
        sx_(hn::Set(d, ray.slope[0])),
        sy_(hn::Set(d, ray.slope[1])),
        backward_(ray.backward ? hn::SignBit(d) : hn::Zero(d)),
        least_(hn::Set(d, ray.least)),
        most_(hn::Set(d, ray.most)),
        least_square_(hn::Set(d, 3 * ray.least * ray.least)),
        most_square_(hn::Set(d, 3 * ray.most * ray.most)) {}

  template <class Rays, class Triangles>
  HWY_INLINE WordVerdict operator()(const Rays&, const Triangles& triangles, std::size_t i) const {
    const D d;
    const Corner a = corner(triangles, 0, i), b = corner(triangles, 3, i), c = corner(triangles, 6, i);
    const V u = hn::MulSub(c.x, b.y, hn::Mul(c.y, b.x));
    const V v = hn::MulSub(a.x, c.y, hn::Mul(a.y, c.x));
    const V w = hn::MulSub(b.x, a.y, hn::Mul(b.y, a.x));
    const V t = hn::NegMulSub(u, a.z, hn::MulAdd(v, b.z, hn::Mul(w, c.z)));
    const V z = hn::MulAdd(a.z, a.z, hn::MulAdd(b.z, b.z, hn::MulAdd(c.z, c.z, hn::Set(d, least_z))));
    // Three chains: one of nine would keep the processor waiting.
    const V xx = hn::MulAdd(a.x, a.x, hn::MulAdd(b.x, b.x, hn::Mul(c.x, c.x)));
    const V yy = hn::MulAdd(a.y, a.y, hn::MulAdd(b.y, b.y, hn::Mul(c.y, c.y)));
    const V q = hn::Add(hn::Add(xx, yy), z);
    const V error = hn::Mul(q, hn::Set(d, edge_error)), squared_error = hn::Mul(error, error);

    // Against the sign of U: where the other two agree with it, the line passes through the triangle.
    const V sign = hn::And(u, hn::SignBit(d)), other_v = hn::Xor(v, sign), other_w = hn::Xor(w, sign);
    const V least_weight = hn::Min(hn::Abs(u), hn::Min(hn::Abs(v), hn::Abs(w)));
    const auto edges_are_certain = hn::And(hn::Gt(least_weight, error), hn::Le(q, hn::Set(d, Bounds<T>::most_squares)));
    const V outside = hn::Or(other_v, other_w);  // its sign bit
    const V forward = hn::Xor(sign, backward_);
    const auto is_certain = [&](V value, V size) {
      return hn::Gt(hn::Mul(value, value), hn::MulAdd(squared_error, size, hn::Set(d, least_square)));
    };
    if constexpr (!has_least && !has_most) {
      const auto settled = hn::And(edges_are_certain, hn::Or(sign_mask(d, outside), is_certain(t, z)));
      return {bits(d, hn::AndNot(sign_mask(d, hn::Or(outside, hn::Xor(t, forward))), settled)), bits(d, settled), 0};
    } else {
      const V whole = hn::Add(u, hn::Add(v, w)), zz = hn::Add(z, z);
      const V from = hn::NegMulAdd(least_, whole, t);
      auto below = is_certain(from, hn::Add(zz, least_square_)), above = below;
      below = hn::And(below, sign_mask(d, hn::Xor(from, forward)));
      above = hn::AndNot(sign_mask(d, hn::Xor(from, forward)), above);
      if constexpr (has_most) {
        const V to = hn::NegMulAdd(most_, whole, t), past = hn::Xor(to, forward);
        const auto end_is_certain = is_certain(to, hn::Add(zz, most_square_));
        below = hn::Or(below, hn::AndNot(sign_mask(d, past), end_is_certain));
        above = hn::And(above, hn::And(end_is_certain, sign_mask(d, past)));
      }
      const auto miss = hn::And(edges_are_certain, hn::Or(sign_mask(d, outside), below));
      const auto hit = hn::AndNot(sign_mask(d, outside), hn::And(edges_are_certain, above));
      return {bits(d, hit), bits(d, hn::Or(hit, miss)), 0};
    }
  }

 private:
  static constexpr T edge_error = T(sheared_error) * Bounds<T>::unit;
  static constexpr T least_z = sizeof(T) == sizeof(float) ? T(0x1p-87) : T(0x1p-900);
  static constexpr T least_square = sizeof(T) == sizeof(float) ? T(0x1p-120) : T(0x1p-1000);

  struct Corner {
    V x, y, z;
  };

  /// Negated: the weights are the same, and what is subtracted is read from memory by the subtraction itself.
  template <class Triangles>
  HWY_INLINE Corner corner(const Triangles& triangles, int k, std::size_t i) const {
    const V x = hn::Sub(ox_, triangles.get(k, i)), y = hn::Sub(oy_, triangles.get(k + 1, i));
    const V z = hn::Sub(oz_, triangles.get(k + 2, i));
    return {hn::NegMulAdd(sx_, z, x), hn::NegMulAdd(sy_, z, y), z};
  }

  static HWY_INLINE WordVerdict verdict(D d, LaneMask<D> settled, LaneMask<D> hit) {
    return {bits(d, hit), bits(d, hn::Not(settled)), 0};
  }

  V ox_, oy_, oz_, sx_, sy_, backward_, least_, most_, least_square_, most_square_;
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
