// A number of twice double's precision, for formulas that are templates: Joldes, Muller and Popescu, "Tight and rigorous error
// bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017: algorithms 6, 12 (here by two products)
// and 17. Relative errors of a few 2^-106. Nothing is said of overflow, underflow or directed rounding.
#pragma once

#include <cmath>

#include "numeric/double_double.hpp"

namespace graze::bench {

struct DoubleWord {
  double hi = 0, lo = 0;

  DoubleWord() = default;
  explicit DoubleWord(double x) : hi(x) {}
  DoubleWord(double h, double l) : hi(h), lo(l) {}

  friend DoubleWord operator-(const DoubleWord& a) { return {-a.hi, -a.lo}; }
  friend DoubleWord operator+(const DoubleWord& a, const DoubleWord& b) {
    const numeric::Pair s = numeric::two_sum(a.hi, b.hi), t = numeric::two_sum(a.lo, b.lo);
    const DoubleWord v = normalised(s.hi, s.lo + t.hi);
    return normalised(v.hi, t.lo + v.lo);
  }
  friend DoubleWord operator-(const DoubleWord& a, const DoubleWord& b) { return a + -b; }
  friend DoubleWord operator*(const DoubleWord& a, const DoubleWord& b) {
    const numeric::Pair p = numeric::two_product(a.hi, b.hi);
    return normalised(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
  }
  friend DoubleWord operator/(const DoubleWord& a, const DoubleWord& b) {
    const double q = a.hi / b.hi;
    const DoubleWord r = a - b * DoubleWord(q);
    return normalised(q, r.hi / b.hi);
  }
  friend auto operator<=>(const DoubleWord& a, const DoubleWord& b) { return a.hi == b.hi ? a.lo <=> b.lo : a.hi <=> b.hi; }
  friend bool operator==(const DoubleWord&, const DoubleWord&) = default;

 private:
  /// |a| >= |b| or a = 0.
  static DoubleWord normalised(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
};

inline DoubleWord square_root(const DoubleWord& a) {
  if (!(a.hi > 0)) return DoubleWord(std::sqrt(a.hi));
  const double s = std::sqrt(a.hi);
  const DoubleWord rest = a - DoubleWord(s) * DoubleWord(s);
  return DoubleWord(s) + DoubleWord(rest.hi / (2 * s));
}
inline double to_double(const DoubleWord& a) {
  return a.hi + a.lo;
}

}  // namespace graze::bench
