// Four doubles side by side, by the compilers' vector extension: each lane is plain IEEE arithmetic, so the bits do not depend
// on how wide the machine's registers are.
#pragma once

#if defined(__FMA__) && defined(__x86_64__)
#include <immintrin.h>
#endif

#include "graze/types.hpp"

namespace graze::numeric {

using Lanes = double __attribute__((vector_size(32)));

/// x, y, z and a fourth number.
template <Real T>
[[nodiscard]] inline Lanes lanes(const Vec3<T>& v, double w = 0) noexcept {
  return Lanes{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z), w};
}

[[nodiscard]] inline Lanes magnitudes(const Lanes& v) noexcept {
  using Integers = long long __attribute__((vector_size(32)));  // NOLINT(google-runtime-int): 64 bits, whatever it is called
  const Integers all_but_sign = Integers{} + 0x7fffffffffffffff;
  return reinterpret_cast<Lanes>(reinterpret_cast<Integers>(v) & all_but_sign);
}

/// y, z, x, w.
[[nodiscard]] inline Lanes rotated(const Lanes& v) noexcept {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

/// a b + c, rounded once, where the machine can; otherwise this is not declared.
#if defined(__FMA__) && defined(__x86_64__)
#define GRAZE_HAS_FMA 1
[[nodiscard]] inline Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
  return static_cast<Lanes>(_mm256_fmadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b), static_cast<__m256d>(c)));
}
[[nodiscard]] inline double fma(double a, double b, double c) noexcept {
  return __builtin_fma(a, b, c);
}
#elif defined(__aarch64__)
#define GRAZE_HAS_FMA 1
[[nodiscard]] inline double fma(double a, double b, double c) noexcept {
  return __builtin_fma(a, b, c);
}
[[nodiscard]] inline Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) noexcept {
  return Lanes{fma(a[0], b[0], c[0]), fma(a[1], b[1], c[1]), fma(a[2], b[2], c[2]), fma(a[3], b[3], c[3])};
}
#else
#define GRAZE_HAS_FMA 0
#endif

/// a x b in the first three lanes: (a * b.yzx - a.yzx * b).yzx.
[[nodiscard]] inline Lanes cross(const Lanes& a, const Lanes& b) noexcept {
  return rotated(a * rotated(b) - rotated(a) * b);
}

/// The four rows' first, second, third and fourth numbers.
struct Columns {
  Lanes first, second, third, fourth;
};

[[nodiscard]] inline Columns transposed(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) noexcept {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
          __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7), __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)};
}

}  // namespace graze::numeric
