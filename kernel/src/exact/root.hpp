// The exact value of a root of A t^2 - 2 B t + C, with A > 0 and D = B^2 - A C > 0: (B -+ sqrt(D)) / A, times 2^scale.
#pragma once

#include "numeric/rounding.hpp"

namespace graze::exact {

using numeric::Approximation;
using numeric::Dyadic;
using numeric::Integer;

/// The roots' common ground, over integers of K-limb coordinates. |A|, |B|, |C| < 2^(128 K - 2).
template <int K>
struct Quadratic {
  Integer<2 * K> a, b, c;
  Integer<4 * K> discriminant;
  int scale;
};

template <int K>
class QuadraticRoot {
 public:
  QuadraticRoot(const Quadratic<K>& quadratic, bool second) noexcept : quadratic_(quadratic), second_(second) {}

  /// Between the roots where C < 0; otherwise both lie on B's side, and where C = 0 the one nearer to zero is zero.
  [[nodiscard]] int sign() const noexcept {
    const int b = quadratic_.b.sign(), c = quadratic_.c.sign();
    if (c < 0) return second_ ? 1 : -1;
    return c == 0 && is_near() ? 0 : b;
  }

  /// With q = B + sgn+(B) sqrt(D), sgn+(0) = 1: C / q is the root nearer to zero, q / A the farther. Nothing cancels, and q is
  /// not zero because D > 0.
  [[nodiscard]] Approximation approximation() const noexcept {
    const Approximation q = add_magnitudes(leading(quadratic_.b), square_root(leading(quadratic_.discriminant)));
    Approximation t = is_near() ? quotient(leading(quadratic_.c), q) : quotient(q, leading(quadratic_.a));
    t.exponent += quadratic_.scale;
    return t;
  }

  /// The sign of root - x, from the signs of g = A x - B and f = A x^2 - 2 B x + C:
  /// t1 > x where g < 0 and f > 0, t2 > x where g < 0 or f < 0; the root is x where f = 0 on its side of the vertex.
  ///
  /// Widths, with x = m 2^q in units of the scaled roots, |m| < 2^54, next to a root t != 0 (so C is not 0 where it is the
  /// nearer one): |B|, |C|, |A| < 2^w with w = 128 K - 2. For q >= 0, A x^2 is at most 4 B^2 / A up to a unit: 2 w + 2 bits.
  /// For q < 0 all is multiplied by 2^-2q; |t| >= |C| / 2|B| >= 1 / 2|B| gives 2^-q < 2|B| m, so the largest term, 2 B m 2^-q,
  /// is below 2^(2 w + 2 + 108), and 4 K + 2 limbs have 2 w + 4 + 128 bits.
  [[nodiscard]] int compare_near(const Dyadic& x) const noexcept {
    using numeric::extend;
    constexpr int width = 4 * K + 2;
    const int q = x.exponent - quadratic_.scale;
    const Integer<1> m = numeric::integer<1>({x.mantissa, 0, x.negative}, 0);
    Integer<width> am = extend<width>(quadratic_.a * m);
    Integer<width> amm = extend<width>(quadratic_.a * (m * m));
    Integer<width> b = extend<width>(quadratic_.b);
    Integer<width> bm2 = shift_left(extend<width>(quadratic_.b * m), 1);
    Integer<width> c = extend<width>(quadratic_.c);
    if (q >= 0) {
      am = shift_left(am, q);
      amm = shift_left(amm, 2 * q);
      bm2 = shift_left(bm2, q);
    } else {
      b = shift_left(b, -q);
      bm2 = shift_left(bm2, -q);
      c = shift_left(c, -2 * q);
    }
    const int g = compare(am, b);
    const int f = (amm - bm2 + c).sign();
    if (f == 0 && (second_ ? g >= 0 : g <= 0)) return 0;
    const bool above = second_ ? g < 0 || f < 0 : g < 0 && f > 0;
    return above ? 1 : -1;
  }

 private:
  /// The first root is the nearer one where sgn+(B) = 1.
  [[nodiscard]] bool is_near() const noexcept { return second_ == quadratic_.b.is_negative(); }

  const Quadratic<K>& quadratic_;
  bool second_;
};

}  // namespace graze::exact
