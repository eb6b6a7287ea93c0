// Error-free transforms and pairs of doubles (Dekker 1971; Ogita, Rump & Oishi 2005), for one number or for lanes of four.
// Exact only in rounding to nearest, without contraction and without excess precision: this header is for the library's own
// files, which ask `rounds_to_nearest` first and are compiled with contraction off.
#pragma once

#include <cfloat>

#include "numeric/lanes.hpp"

static_assert(FLT_EVAL_METHOD == 0, "graze: compile the library for arithmetic in double, not wider (-mfpmath=sse)");

namespace graze::numeric {

/// Whether the caller's rounding mode is to nearest, asked of the arithmetic itself.
[[nodiscard]] inline bool rounds_to_nearest() noexcept {
  static const volatile double tiny = 0x1p-60;
  const double t = tiny;
  return 1.0 + t == 1.0 && 1.0 - t == 1.0;
}

/// hi + lo, not necessarily normalised: |lo| may be as large as a few units of the terms that were summed to it.
template <class V>
struct PairOf {
  V hi, lo;
};
using Pair = PairOf<double>;
using PairLanes = PairOf<Lanes>;

/// a + b = hi + lo exactly.
template <class V>
[[nodiscard]] inline PairOf<V> two_sum(const V& a, const V& b) noexcept {
  const V s = a + b, bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// a - b = hi + lo exactly.
template <class V>
[[nodiscard]] inline PairOf<V> two_difference(const V& a, const V& b) noexcept {
  const V s = a - b, bb = s - a;
  return {s, (a - (s - bb)) - (b + bb)};
}

/// a b = hi + lo exactly, for products away from overflow and underflow.
template <class V>
[[nodiscard]] inline PairOf<V> two_product(const V& a, const V& b) noexcept {
  const V p = a * b;
#if GRAZE_HAS_FMA
  return {p, fma(a, b, -p)};
#else
  // Veltkamp's split; without a hardware FMA the library call would cost more than this does.
  constexpr double splitter = 0x1p27 + 1;
  const V ta = splitter * a, tb = splitter * b;
  const V ah = ta - (ta - a), bh = tb - (tb - b);
  const V al = a - ah, bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

/// For normalised pairs errs by at most 4 * 2^-106 (|a| + |b|), absolutely: cancellation is the caller's bound to count.
template <class V>
[[nodiscard]] inline PairOf<V> operator+(const PairOf<V>& a, const PairOf<V>& b) noexcept {
  const PairOf<V> s = two_sum(a.hi, b.hi);
  return {s.hi, s.lo + (a.lo + b.lo)};
}

template <class V>
[[nodiscard]] inline PairOf<V> operator-(const PairOf<V>& a, const PairOf<V>& b) noexcept {
  const PairOf<V> s = two_difference(a.hi, b.hi);
  return {s.hi, s.lo + (a.lo - b.lo)};
}

template <class V>
[[nodiscard]] inline PairOf<V> operator*(const V& a, const PairOf<V>& b) noexcept {
  const PairOf<V> p = two_product(a, b.hi);
  return {p.hi, p.lo + a * b.lo};
}

template <class V>
[[nodiscard]] inline PairOf<V> operator*(const PairOf<V>& a, const PairOf<V>& b) noexcept {
  const PairOf<V> p = two_product(a.hi, b.hi);
  return {p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi)};
}

/// The same value with |lo| at most half a unit of hi.
template <class V>
[[nodiscard]] inline PairOf<V> normalised(const PairOf<V>& a) noexcept {
  return two_sum(a.hi, a.lo);
}

/// n / d for normalised pairs: relative error below 2^-102 (kernel/proofs/face.g).
template <class V>
[[nodiscard]] inline PairOf<V> operator/(const PairOf<V>& n, const PairOf<V>& d) noexcept {
  const V q = n.hi / d.hi;
  const PairOf<V> p = two_product(q, d.hi);
  const V rest = ((n.hi - p.hi) - p.lo) + (n.lo - q * d.lo);
  return {q, rest / d.hi};
}

[[nodiscard]] inline Lanes rotated_lanes(const Lanes& v) noexcept {
  return rotated(v);
}
[[nodiscard]] inline PairLanes rotated_lanes(const PairLanes& v) noexcept {
  return {rotated(v.hi), rotated(v.lo)};
}

/// a x b in the first three lanes: (a * b.yzx - a.yzx * b).yzx.
template <class A>
[[nodiscard]] inline PairLanes cross(const A& a, const PairLanes& b) noexcept {
  return rotated_lanes(a * rotated_lanes(b) - rotated_lanes(a) * b);
}

/// Four sums of lanes at once.
[[nodiscard]] inline PairLanes sums(const PairLanes& a, const PairLanes& b, const PairLanes& c, const PairLanes& d) noexcept {
  const Columns hi = transposed(a.hi, b.hi, c.hi, d.hi), lo = transposed(a.lo, b.lo, c.lo, d.lo);
  return (PairLanes{hi.first, lo.first} + PairLanes{hi.second, lo.second}) +
         (PairLanes{hi.third, lo.third} + PairLanes{hi.fourth, lo.fourth});
}

}  // namespace graze::numeric
