// Two numbers side by side in one register of 16 bytes: every lane is plain IEEE arithmetic. A filter's determinants come in
// pairs, which halves its instructions. Lanes of floats past the second hold zeros or what these operations make of them.
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <cstdint>

namespace graze::numeric {

// Without SSE2 vectors are handed over otherwise. On 32-bit x86 the library has it and its caller perhaps not: a function of
// both must not stand for either.
#if defined(__SSE2__)
inline namespace sse2 {
#else
inline namespace generic {
#endif

template <class W>
struct TwoLanesOf;
template <>
struct TwoLanesOf<float> {
  typedef float type __attribute__((vector_size(16)));
  typedef std::uint32_t Bits __attribute__((vector_size(16)));
};
template <>
struct TwoLanesOf<double> {
  typedef double type __attribute__((vector_size(16)));
  typedef std::uint64_t Bits __attribute__((vector_size(16)));
};

template <class W>
using TwoLanes = typename TwoLanesOf<W>::type;

[[nodiscard]] inline TwoLanes<double> two_lanes(double first, double second) noexcept {
  return TwoLanes<double>{first, second};
}
[[nodiscard]] inline TwoLanes<float> two_lanes(float first, float second) noexcept {
#if defined(__SSE4_1__)
  return _mm_insert_ps(_mm_set_ss(first), _mm_set_ss(second), 0x10);
#elif defined(__SSE2__)
  return _mm_unpacklo_ps(_mm_set_ss(first), _mm_set_ss(second));
#else
  return TwoLanes<float>{first, second, 0, 0};
#endif
}

/// x in every lane.
[[nodiscard]] inline TwoLanes<double> both(double x) noexcept {
  return TwoLanes<double>{x, x};
}
[[nodiscard]] inline TwoLanes<float> both(float x) noexcept {
  return TwoLanes<float>{x, x, x, x};
}

/// a - b in the first lane, a in the others.
[[nodiscard]] inline TwoLanes<double> subtract_first(TwoLanes<double> a, TwoLanes<double> b) noexcept {
#if defined(__SSE2__)
  return _mm_sub_sd(a, b);
#else
  return TwoLanes<double>{a[0] - b[0], a[1]};
#endif
}
[[nodiscard]] inline TwoLanes<float> subtract_first(TwoLanes<float> a, TwoLanes<float> b) noexcept {
#if defined(__SSE2__)
  return _mm_sub_ss(a, b);
#else
  return TwoLanes<float>{a[0] - b[0], a[1], 0, 0};
#endif
}

/// The first two lanes changed about.
[[nodiscard]] inline TwoLanes<double> swapped(TwoLanes<double> v) noexcept {
  return __builtin_shufflevector(v, v, 1, 0);
}
[[nodiscard]] inline TwoLanes<float> swapped(TwoLanes<float> v) noexcept {
  return __builtin_shufflevector(v, v, 1, 0, 2, 3);
}

/// The first lane in both.
[[nodiscard]] inline TwoLanes<double> first_in_both(TwoLanes<double> v) noexcept {
  return __builtin_shufflevector(v, v, 0, 0);
}
[[nodiscard]] inline TwoLanes<float> first_in_both(TwoLanes<float> v) noexcept {
  return __builtin_shufflevector(v, v, 0, 0, 2, 2);
}

/// a b + c, in one rounding where the machine does that fast.
[[nodiscard]] inline TwoLanes<double> multiply_add(TwoLanes<double> a, TwoLanes<double> b, TwoLanes<double> c) noexcept {
#if defined(__SSE2__) && defined(__FMA__)
  return _mm_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}
[[nodiscard]] inline TwoLanes<float> multiply_add(TwoLanes<float> a, TwoLanes<float> b, TwoLanes<float> c) noexcept {
#if defined(__SSE2__) && defined(__FMA__)
  return _mm_fmadd_ps(a, b, c);
#else
  return a * b + c;
#endif
}

/// The sign bits alone, and all bits but those; x with the sign of a where `signs` are a's sign bits, times x's own.
template <class W>
using LaneBits = typename TwoLanesOf<W>::Bits;

template <class W>
inline constexpr auto lane_sign_bit =
    static_cast<std::conditional_t<sizeof(W) == 4, std::uint32_t, std::uint64_t>>(std::uint64_t(1) << (8 * sizeof(W) - 1));

template <class W>
[[nodiscard]] inline TwoLanes<W> magnitudes_of(TwoLanes<W> v) noexcept {
  return reinterpret_cast<TwoLanes<W>>(reinterpret_cast<LaneBits<W>>(v) & (LaneBits<W>{} + (lane_sign_bit<W> - 1)));
}

/// The first lane's sign bit, in both lanes.
template <class W>
[[nodiscard]] inline LaneBits<W> first_sign_in_both(TwoLanes<W> v) noexcept {
  return reinterpret_cast<LaneBits<W>>(first_in_both(v)) & (LaneBits<W>{} + lane_sign_bit<W>);
}

/// v, its sign changed where `signs` has the sign bit.
template <class W>
[[nodiscard]] inline TwoLanes<W> flipped(TwoLanes<W> v, LaneBits<W> signs) noexcept {
  return reinterpret_cast<TwoLanes<W>>(reinterpret_cast<LaneBits<W>>(v) ^ signs);
}

}  // namespace sse2 or generic
}  // namespace graze::numeric
