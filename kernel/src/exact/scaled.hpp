// Inputs as integers: positions in units of one power of two, directions in units of another, in the fewest limbs of five
// tiers.
#pragma once

#include "graze/types.hpp"
#include "numeric/integer.hpp"

namespace graze::exact {

using numeric::Dyadic;
using numeric::DyadicVec3;
using numeric::Extent;
using numeric::Integer;

template <int N>
struct IntegerVec3 {
  Integer<N> x, y, z;
};

template <int K>
[[nodiscard]] inline IntegerVec3<K> integer_vec3(const DyadicVec3& v, int unit) noexcept {
  return {numeric::integer<K>(v.x, unit), numeric::integer<K>(v.y, unit), numeric::integer<K>(v.z, unit)};
}

template <int N>
[[nodiscard]] inline IntegerVec3<N> operator-(const IntegerVec3<N>& a, const IntegerVec3<N>& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <int N, int M>
[[nodiscard]] inline Integer<N + M> dot(const IntegerVec3<N>& a, const IntegerVec3<M>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <int N, int M>
[[nodiscard]] inline IntegerVec3<N + M> cross(const IntegerVec3<N>& a, const IntegerVec3<M>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <int N>
[[nodiscard]] inline bool is_zero(const IntegerVec3<N>& v) noexcept {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

/// Inputs of K limbs have at most this many bits; the four spare bits pay for the differences and the sums of products:
/// with w = 64 K - 4, |c - e| < 2^(w+1), A < 2^(2w+2), |B| < 2^(2w+3), |C| < 2^(2w+4) <= 2^(128K-4), |D| < 2^(4w+7) <=
/// 2^(256K-9), and a triangle's determinants stay below 6 * 2^(3w+3) < 2^(192K-6).
template <int K>
inline constexpr int input_bits = 64 * K - 4;

/// Calls f.template operator()<K>() with the least tier K whose inputs have `width` bits. 33 limbs hold all of double: 2,098
/// bits.
template <class F>
inline auto with_tier(int width, F&& f) noexcept {
  if (width <= input_bits<1>) return f.template operator()<1>();
  if (width <= input_bits<2>) return f.template operator()<2>();
  if (width <= input_bits<5>) return f.template operator()<5>();
  if (width <= input_bits<12>) return f.template operator()<12>();
  return f.template operator()<33>();
}

}  // namespace graze::exact
