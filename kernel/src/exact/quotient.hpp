// The exact value numerator / denominator * 2^scale.
#pragma once

#include "numeric/rounding.hpp"

namespace graze::exact {

using numeric::Approximation;
using numeric::Dyadic;
using numeric::Integer;

template <int N>
class Quotient {
 public:
  /// The denominator is not zero. Both magnitudes are below 2^(64 N - 1).
  Quotient(const Integer<N>& numerator, const Integer<N>& denominator, int scale) noexcept
      : numerator_(denominator.is_negative() ? -numerator : numerator), denominator_(abs(denominator)), scale_(scale) {}

  [[nodiscard]] int sign() const noexcept { return numerator_.sign(); }
  [[nodiscard]] const Integer<N>& numerator() const noexcept { return numerator_; }
  /// Positive.
  [[nodiscard]] const Integer<N>& denominator() const noexcept { return denominator_; }
  [[nodiscard]] int scale() const noexcept { return scale_; }

  [[nodiscard]] Approximation approximation() const noexcept {
    Approximation q = quotient(leading(numerator_), leading(denominator_));
    q.exponent += scale_;
    return q;
  }

  /// The sign of n/d 2^scale - x = (n 2^-q - m d) ... for x = m 2^(q + scale) next to the value. There n 2^-q (or m d 2^q) is
  /// as large as m d (or n), below 2^(64 N - 1 + 54) and a little, so N + 2 limbs hold both sides.
  [[nodiscard]] int compare_near(const Dyadic& x) const noexcept {
    const int q = x.exponent - scale_;
    const Integer<1> mantissa = numeric::integer<1>({x.mantissa, 0, x.negative}, 0);
    Integer<N + 2> left = numeric::extend<N + 2>(numerator_);
    Integer<N + 2> right = numeric::extend<N + 2>(denominator_ * mantissa);
    if (q < 0) {
      left = shift_left(left, -q);
    } else {
      right = shift_left(right, q);
    }
    return compare(left, right);
  }

  /// The sign of this - other for the same scale: n1 d2 against n2 d1 with positive denominators.
  [[nodiscard]] int compare_with(const Quotient& other) const noexcept {
    return compare(numerator_ * other.denominator_, other.numerator_ * denominator_);
  }

 private:
  Integer<N> numerator_, denominator_;
  int scale_;
};

}  // namespace graze::exact
