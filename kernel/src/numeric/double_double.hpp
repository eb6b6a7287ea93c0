// Error-free transforms and pairs of doubles (Dekker 1971; Ogita, Rump & Oishi 2005). Exact only in rounding to nearest, without
// contraction and without excess precision: this header is for the library's own files, which ask `rounds_to_nearest` first and
// are compiled with contraction off.
#pragma once

#include <cfloat>

#include "graze/numeric/filter.hpp"

static_assert(FLT_EVAL_METHOD == 0, "graze: compile the library for arithmetic in double, not wider (-mfpmath=sse)");

namespace graze::numeric {

/// Whether the caller's rounding mode is to nearest, asked of the arithmetic itself.
[[nodiscard]] inline bool rounds_to_nearest() noexcept {
  static const volatile double tiny = 0x1p-60;
  const double t = tiny;
  return 1.0 + t == 1.0 && 1.0 - t == 1.0;
}

/// hi + lo, not necessarily normalised: |lo| may be as large as a few units of the terms that were summed to it.
struct Pair {
  double hi, lo;
};

/// a + b = hi + lo exactly.
[[nodiscard]] inline Pair two_sum(double a, double b) noexcept {
  const double s = a + b, bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// a - b = hi + lo exactly.
[[nodiscard]] inline Pair two_difference(double a, double b) noexcept { return two_sum(a, -b); }

/// a b = hi + lo exactly, for products away from overflow and underflow.
[[nodiscard]] inline Pair two_product(double a, double b) noexcept {
  const double p = a * b;
#if defined(__FMA__) || defined(__aarch64__)
  return {p, __builtin_fma(a, b, -p)};
#else
  // Veltkamp's split; without a hardware FMA the library call would cost more than this does.
  constexpr double splitter = 0x1p27 + 1;
  const double ta = splitter * a, tb = splitter * b;
  const double ah = ta - (ta - a), bh = tb - (tb - b);
  const double al = a - ah, bl = b - bh;
  return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

[[nodiscard]] inline Pair operator-(Pair a) noexcept { return {-a.hi, -a.lo}; }

/// Errs by at most 4 * 2^-106 (|a| + |b|), absolutely: cancellation is the caller's bound to count.
[[nodiscard]] inline Pair operator+(Pair a, Pair b) noexcept {
  const Pair s = two_sum(a.hi, b.hi);
  return {s.hi, s.lo + (a.lo + b.lo)};
}

[[nodiscard]] inline Pair operator-(Pair a, Pair b) noexcept { return a + -b; }

[[nodiscard]] inline Pair operator*(double a, Pair b) noexcept {
  const Pair p = two_product(a, b.hi);
  return {p.hi, p.lo + a * b.lo};
}

[[nodiscard]] inline Pair operator*(Pair a, Pair b) noexcept {
  const Pair p = two_product(a.hi, b.hi);
  return {p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi)};
}

/// The same value with |lo| at most half a unit of hi.
[[nodiscard]] inline Pair normalised(Pair a) noexcept { return two_sum(a.hi, a.lo); }

/// n / d for normalised pairs: relative error below 2^-100.
[[nodiscard]] inline Pair operator/(Pair n, Pair d) noexcept {
  const double q = n.hi / d.hi;
  const Pair p = two_product(q, d.hi);
  const double rest = ((n.hi - p.hi) - p.lo) + (n.lo - q * d.lo);
  return {q, rest / d.hi};
}

/// The square root of a normalised positive pair: relative error below 2^-100.
[[nodiscard]] inline Pair square_root(Pair a) noexcept {
  const double s = __builtin_sqrt(a.hi);
  const Pair p = two_product(s, s);
  const double rest = ((a.hi - p.hi) - p.lo) + a.lo;
  return {s, rest / (2 * s)};
}

struct PairVector {
  Pair x, y, z;
};

[[nodiscard]] inline PairVector exact_difference(const Vector& a, const Vector& b) noexcept {
  return {two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z)};
}

template <class A>
[[nodiscard]] inline Pair dot(const A& a, const PairVector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class A>
[[nodiscard]] inline PairVector cross(const A& a, const PairVector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace graze::numeric
