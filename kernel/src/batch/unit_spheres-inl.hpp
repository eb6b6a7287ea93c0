// One ray without upper end against many spheres, decisions alone, in rounding to nearest. With the direction d as long as 1, L
// = c - e:
//   Q = L.L,  B = d.L,  C = Q - r^2,  D = B^2 - C
// 11 operations and no division; the ray's share is computed once.
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

/// The bounds, in rounding to nearest. Write v for half of `unit`, and A, b for the given direction's d.d and d.L, so that B
/// stands for b / sqrt(A) and D for (b^2 - A C) / A.
///  - The length errs by 2.5 v of itself: half of what A does, and the root; each component by v more.
///  - B: monomials of 4 roundings and that one, together at most |L|, and the length: 7.5 v |L|; so B^2 by 15 v Q and v.
///  - C: Q by 5 v of itself, r^2 by v, and the difference. While r^2 <= Q that is 7 v Q, and for D 25 v Q in all; 32 v Q is
///    taken, unit_sphere_error: kernel/proofs/batch_spheres.g.
///  - C's sign is right beyond the bound, whatever r^2: where r^2 > Q, what is computed of C is at most what it may be at
///    r^2 = Q, 7 v Q.
///  - Below zero, D is above it, and so is what is computed of D: B^2 - C as rounded is no less than -C. Above, r^2 < Q, and
///    D's sign is right beyond the bound. Where it is above zero too, |B| > sqrt(C) > 5 sqrt(v) |L|: B's computed sign is
///    right.
/// Beyond the bound need be only the lesser of D and C: where that is D, below zero, C is as computed at least -D.
/// What underflows, with f for `flushed`: as in spheres-inl.hpp for A = 1, that is 2^-20 of 4 v Q, or 2^21 f holds it.
/// What overflows: where Q does, so does the bound, and nothing exceeds it; where it does not, a multiply-add that is rounded
/// once makes C and D infinite only where they are that great; where it is rounded twice, 2 Q is asked not to overflow, for
/// then B^2 does not, and r^2 only where it is greater than Q. A NaN exceeds nothing. An infinite radius or one with its sign
/// bit set settles nothing.
template <class D>
class UnitSpheres {
 public:
  using T = hn::TFromD<D>;
  using V = Lanes<D>;

  HWY_INLINE UnitSpheres(D d, const UnitRay<T>& ray)
      : origin_{hn::Set(d, ray.origin[0]), hn::Set(d, ray.origin[1]), hn::Set(d, ray.origin[2])},
        direction_{hn::Set(d, ray.direction[0]), hn::Set(d, ray.direction[1]), hn::Set(d, ray.direction[2])} {}

  template <class Rays, class Spheres>
  HWY_INLINE WordVerdict operator()(const Rays&, const Spheres& spheres, std::size_t i) const {
    const D d;
    const Terms terms = terms_of(spheres, i);
    const auto settled = hn::And(hn::Gt(terms.least, terms.error), AllFinite<D>::of(terms.r));
    return {bits(d, sign_mask(d, terms.is_hit)), bits(d, settled), 0};
  }

  /// batch::settle_words: a few words at a time, so that little is lost where there is doubt.
  HWY_INLINE std::size_t settle_words(const SphereColumns<T>& columns, std::size_t first, std::size_t words,
                                      std::uint64_t* mask) const {
    const D d;
    const std::size_t step = hn::Lanes(d);
    constexpr std::size_t words_at_a_time = 4;
    Source<D, 4, true> spheres(columns);
    spheres.advance(first);
    for (std::size_t word = 0; word < words;) {
      const std::size_t end = words - word < words_at_a_time ? words : word + words_at_a_time, start = word;
      Certainty certainty;
      for (; word < end; ++word) {
        std::uint64_t hit = 0;
        for (std::size_t lane = 0; lane < 64; lane += 4 * step) {
          // As in lanes-inl.hpp.
          std::uint64_t group = hits(spheres, 0, certainty);
          group |= hits(spheres, step, certainty) << step;
          group |= hits(spheres, 2 * step, certainty) << (2 * step);
          group |= hits(spheres, 3 * step, certainty) << (3 * step);
          hit |= group << lane;
          spheres.advance(4 * step);
        }
        mask[word] = hit;
      }
      if (!certainty.decisions.holds() || !certainty.radii.holds()) return start;
    }
    return words;
  }

 private:
  static constexpr T bound = T(unit_sphere_error) * Bounds<T>::unit, flushed = T(0x1p21) * Bounds<T>::flushed;

  struct Terms {
    V r, least, error;
    V is_hit;  ///< its sign bit: roots, and inside or ahead
  };
  struct Certainty {
    AllGreater<D> decisions;
    AllFinite<D> radii;
    HWY_INLINE Certainty() {}
  };

  template <class Spheres>
  HWY_INLINE Terms terms_of(const Spheres& spheres, std::size_t i) const {
    const D d;
    // L and B negated: what is subtracted is read from memory by the subtraction itself.
    const Vector3<D> l = origin_ - spheres.vector(0, i);
    const V r = spheres.get(3, i), b = dot<D>(direction_, l), q = dot<D>(l, l);
    const V c = hn::NegMulAdd(r, r, q), discriminant = hn::MulSub(b, b, c);
    return {r, least_magnitude(d, discriminant, c), error(q), hn::AndNot(discriminant, hn::Or(c, b))};
  }
  static HWY_INLINE V error(V q) {
    const D d;
#if HWY_NATIVE_FMA
    return hn::MulAdd(q, hn::Set(d, bound), hn::Set(d, flushed));
#else
    return hn::MulAdd(hn::Add(q, q), hn::Set(d, bound / 2), hn::Set(d, flushed));
#endif
  }

  template <class Spheres>
  HWY_INLINE std::uint64_t hits(const Spheres& spheres, std::size_t i, Certainty& certainty) const {
    const Terms terms = terms_of(spheres, i);
    certainty.decisions.include(terms.least, terms.error);
    certainty.radii.include(terms.r);
    return bits(D(), sign_mask(D(), terms.is_hit));
  }

  Vector3<D> origin_, direction_;
};

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
