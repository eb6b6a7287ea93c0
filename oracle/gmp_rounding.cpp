#include "oracle/gmp_rounding.hpp"

#include <algorithm>

#include "oracle/gmp_dyadic.hpp"

namespace graze::oracle::gmp {
namespace {

[[nodiscard]] long bit_length(const mpz_class& x) {
  return sgn(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
}

void shift_left(mpz_class& out, const mpz_class& x, long bits) {
  mpz_mul_2exp(out.get_mpz_t(), x.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
}

/// Some k for which |b + root_sign * sqrt(d)| / a * 2^k has about `digits` bits; where the two terms cancel, the size of
/// the sum is read off from (b^2 - d) / (|b| + sqrt(d)).
[[nodiscard]] long scale_for_digits(const mpz_class& b, bool cancels, const mpz_class& d, const mpz_class& a, int digits) {
  const long larger = std::max(bit_length(b), bit_length(d) / 2);
  long size = larger;
  if (cancels) {
    thread_local mpz_class difference;
    mpz_mul(difference.get_mpz_t(), b.get_mpz_t(), b.get_mpz_t());
    difference -= d;
    size = bit_length(difference) - larger - 1;
  }
  return std::max(0L, digits + 2 - (size - bit_length(a)));
}

}  // namespace

void truncate_quotient(Truncated& out, const mpz_class& numerator, const mpz_class& denominator, long exponent, int digits) {
  thread_local mpz_class scaled, remainder;
  out.sign = sgn(numerator);
  out.exponent = exponent;
  out.exact = true;
  if (out.sign == 0) {
    out.head = 0;
    return;
  }
  const long shift = std::max(0L, digits + 1 - (bit_length(numerator) - bit_length(denominator)));
  shift_left(scaled, numerator, shift);
  mpz_tdiv_qr(out.head.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t(), denominator.get_mpz_t());
  mpz_abs(out.head.get_mpz_t(), out.head.get_mpz_t());
  out.exponent -= shift;
  out.exact = sgn(remainder) == 0;
}

int sign_of_root(const mpz_class& b, int root_sign, const mpz_class& d) {
  const int root = sgn(d) == 0 ? 0 : root_sign;
  if (root == 0) return sgn(b);
  if (sgn(b) == 0 || sgn(b) == root) return root;
  thread_local mpz_class square;
  mpz_mul(square.get_mpz_t(), b.get_mpz_t(), b.get_mpz_t());
  const int larger = cmp(square, d);
  return larger == 0 ? 0 : (larger > 0 ? sgn(b) : root);
}

void truncate_root(Truncated& out, const mpz_class& b, int root_sign, const mpz_class& d, const mpz_class& a, long exponent,
                   int digits) {
  const int sign = sign_of_root(b, root_sign, d);
  if (root_sign == 0 || sgn(d) == 0 || sign == 0) {
    static const mpz_class zero = 0;
    truncate_quotient(out, sign == 0 ? zero : b, a, exponent, digits);
    return;
  }
  // The magnitude is (beta + rho * sqrt(d)) / a, a positive number.
  thread_local mpz_class beta, scaled, root, remainder;
  if (sign < 0) {
    mpz_neg(beta.get_mpz_t(), b.get_mpz_t());
  } else {
    beta = b;
  }
  const int rho = sign * root_sign;
  out.sign = sign;
  for (long k = scale_for_digits(b, sgn(beta) * rho < 0, d, a, digits);; k += digits) {
    // With integers, floor((x + y) / a) = floor((x + floor(y)) / a) for integer x and real y; -sqrt floors to -ceil(sqrt).
    shift_left(scaled, d, 2 * k);
    mpz_sqrtrem(root.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t());
    const bool square = sgn(remainder) == 0;
    shift_left(scaled, beta, k);
    if (rho > 0) {
      scaled += root;
    } else {
      scaled -= root;
      if (!square) scaled -= 1;
    }
    mpz_fdiv_qr(out.head.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t(), a.get_mpz_t());
    out.exact = square && sgn(remainder) == 0;
    out.exponent = exponent - k;
    if (out.exact || bit_length(out.head) >= digits) return;
  }
}

long floor_log2(const Truncated& x) {
  return bit_length(x.head) - 1 + x.exponent;
}

template <Real T>
T nearest(const Truncated& x) {
  using F = Format<T>;
  if (x.sign == 0) return T(0);
  const long top = floor_log2(x);
  auto bits = F::kInfinity;
  if (top <= F::kMaxExponent) {
    const long ulp = std::max<long>(top - (F::kDigits - 1), F::kMinUlp);
    const long drop = ulp - x.exponent;
    typename F::Bits significand = 0;
    if (drop <= 0) {
      // Only an exact head is that short.
      significand = static_cast<typename F::Bits>(mpz_get_ui(x.head.get_mpz_t()) << -drop);
    } else if (drop <= bit_length(x.head)) {
      const auto half_place = static_cast<mp_bitcnt_t>(drop - 1);
      thread_local mpz_class kept;
      mpz_fdiv_q_2exp(kept.get_mpz_t(), x.head.get_mpz_t(), static_cast<mp_bitcnt_t>(drop));
      significand = static_cast<typename F::Bits>(mpz_get_ui(kept.get_mpz_t()));
      const bool at_least_half = mpz_tstbit(x.head.get_mpz_t(), half_place) != 0;
      const bool off_half = !x.exact || mpz_scan1(x.head.get_mpz_t(), 0) < half_place;
      if (at_least_half && (off_half || (significand & 1) != 0)) ++significand;
    }
    // Adding the significand whole, hidden bit included, carries into the exponent where it must, up to infinity.
    bits = static_cast<typename F::Bits>((static_cast<typename F::Bits>(ulp - F::kMinUlp) << (F::kDigits - 1)) + significand);
  }
  if (bits != 0 && x.sign < 0) bits |= F::kSignBit;
  return std::bit_cast<T>(bits);
}

template float nearest<float>(const Truncated&);
template double nearest<double>(const Truncated&);

}  // namespace graze::oracle::gmp
