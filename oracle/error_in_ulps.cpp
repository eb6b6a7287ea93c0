// The error of a number against an exact real, in units of its last place: computed in integers and rounded once, at the end.
#include <cmath>
#include <limits>

#include "oracle/gmp_dyadic.hpp"
#include "oracle/gmp_rounding.hpp"
#include "oracle/oracle.hpp"

namespace graze::oracle {
namespace {

/// The same real as (b + root_sign * sqrt(d)) / a in integers, a > 0.
struct IntegerRoot {
  mpz_class a, b, d;
  int root_sign = 0;
};

[[nodiscard]] IntegerRoot to_integers(const Exact& value) {
  const mpz_class& num = value.rational.get_num();
  const mpz_class& den = value.rational.get_den();
  if (value.root_sign == 0) return {den, num, 0, 0};
  // n/m + s sqrt(p/q) = (n q + s sqrt(m^2 p q)) / (m q)
  const mpz_class& p = value.radicand.get_num();
  const mpz_class& q = value.radicand.get_den();
  return {den * q, num * q, den * den * p * q, value.root_sign};
}

/// value - x, for a finite x.
void subtract(IntegerRoot& value, const gmp::Dyadic& x) {
  if (x.mantissa == 0) return;
  mpz_class shifted = value.a * static_cast<long>(x.mantissa);
  if (x.exponent >= 0) {
    shifted <<= static_cast<mp_bitcnt_t>(x.exponent);
  } else {
    const auto places = static_cast<mp_bitcnt_t>(-x.exponent);
    value.a <<= places;
    value.b <<= places;
    value.d <<= 2 * places;
  }
  value.b -= shifted;
}

/// The exponent of the spacing of the format at a real: 2^kMinUlp below the normal range, and never above the largest spacing.
template <Real T>
[[nodiscard]] long ulp_exponent(const gmp::Truncated& value) {
  using F = gmp::Format<T>;
  if (value.sign == 0) return F::kMinUlp;
  const long top = std::min<long>(gmp::floor_log2(value), F::kMaxExponent);
  return std::max<long>(top - (F::kDigits - 1), F::kMinUlp);
}

}  // namespace

template <Real T>
double error_in_ulps(const Exact& value, T x) {
  IntegerRoot root = to_integers(value);
  gmp::Truncated truncated;
  gmp::truncate_root(truncated, root.b, root.root_sign, root.d, root.a, 0, gmp::kRoundingDigits<T>);
  if (!gmp::is_finite(x)) {
    return gmp::order(gmp::nearest<T>(truncated)) == gmp::order(x) ? 0 : std::numeric_limits<double>::infinity();
  }
  const long ulp = ulp_exponent<T>(truncated);
  subtract(root, gmp::dyadic(x));
  gmp::truncate_root(truncated, root.b, root.root_sign, root.d, root.a, -ulp, gmp::kRoundingDigits<double>);
  truncated.sign = std::abs(truncated.sign);
  return gmp::nearest<double>(truncated);
}

template double error_in_ulps<float>(const Exact&, float);
template double error_in_ulps<double>(const Exact&, double);

}  // namespace graze::oracle
