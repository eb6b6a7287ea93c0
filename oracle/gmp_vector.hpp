// Vectors of integers, written in place: the oracle lives from reusing its limbs.
#pragma once

#include <gmpxx.h>

#include <array>

#include "oracle/gmp_dyadic.hpp"

namespace graze::oracle::gmp {

using Vector = std::array<mpz_class, 3>;
using DyadicVector = std::array<Dyadic, 3>;

template <Real T>
[[nodiscard]] DyadicVector dyadic(const Vec3<T>& v) {
  return {dyadic(v.x), dyadic(v.y), dyadic(v.z)};
}

/// out = v / 2^unit.
inline void scale(Vector& out, const DyadicVector& v, int unit) {
  for (std::size_t i = 0; i < 3; ++i) scale(out[i], v[i], unit);
}

/// out = a - b; out may be either.
inline void subtract(Vector& out, const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i) mpz_sub(out[i].get_mpz_t(), a[i].get_mpz_t(), b[i].get_mpz_t());
}

/// out = a . b; out is no component of either.
inline void dot(mpz_class& out, const Vector& a, const Vector& b) {
  mpz_mul(out.get_mpz_t(), a[0].get_mpz_t(), b[0].get_mpz_t());
  mpz_addmul(out.get_mpz_t(), a[1].get_mpz_t(), b[1].get_mpz_t());
  mpz_addmul(out.get_mpz_t(), a[2].get_mpz_t(), b[2].get_mpz_t());
}

/// Component i of a x b.
inline void cross(mpz_class& out, const Vector& a, const Vector& b, std::size_t i) {
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  mpz_mul(out.get_mpz_t(), a[j].get_mpz_t(), b[k].get_mpz_t());
  mpz_submul(out.get_mpz_t(), a[k].get_mpz_t(), b[j].get_mpz_t());
}

/// out = a x b; out is neither of them.
inline void cross(Vector& out, const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i) cross(out[i], a, b, i);
}

[[nodiscard]] inline bool is_zero(const Vector& v) {
  return sgn(v[0]) == 0 && sgn(v[1]) == 0 && sgn(v[2]) == 0;
}

/// The first axis on which v does not vanish; v is not zero.
[[nodiscard]] inline std::size_t nonzero_axis(const Vector& v) {
  return sgn(v[0]) != 0 ? 0 : sgn(v[1]) != 0 ? 1 : 2;
}

}  // namespace graze::oracle::gmp
