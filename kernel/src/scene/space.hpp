// Box space: where bounding boxes live. Coordinates relative to a point in the midst of the scene, scaled by a power of two so
// that all shapes lie in [-1, 1]^3 or so: boxes of floats resolve a scene however far from zero, large or small it is.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "graze/numeric/bits.hpp"
#include "graze/types.hpp"

namespace graze::scene {

/// x as a double, exact also where denormals are read as zero; subnormal doubles are not mended.
[[nodiscard]] inline double to_double(float x) noexcept {
  const std::uint32_t magnitude = numeric::magnitude_bits(x);
  if (magnitude >= 0x00800000u) return static_cast<double>(x);
  const double size = static_cast<double>(static_cast<std::int32_t>(magnitude)) * 0x1p-149;
  return (numeric::bits_of(x) & numeric::sign_bit<float>) != 0 ? -size : size;
}
[[nodiscard]] inline double to_double(double x) noexcept {
  return x;
}

/// 2^exponent, which is the exponent of a normal double.
[[nodiscard]] inline double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// floor(log2 |x|) of a normal x.
template <Real T>
[[nodiscard]] inline int exponent_of(T x) noexcept {
  using Format = numeric::FormatOf<T>;
  constexpr int bias = (1 << (Format::exponent_bits - 1)) - 1;
  return static_cast<int>(numeric::magnitude_bits(x) >> (Format::precision - 1)) - bias;
}

/// Bounds are finite, and normal or zero, for where denormals are zero a subnormal bound would move inward.
struct Box {
  float low[3], high[3];

  static Box empty() noexcept { return {{0x1p100f, 0x1p100f, 0x1p100f}, {-0x1p100f, -0x1p100f, -0x1p100f}}; }
  void include(const Box& other) noexcept {
    for (int k = 0; k < 3; ++k) {
      low[k] = other.low[k] < low[k] ? other.low[k] : low[k];
      high[k] = other.high[k] > high[k] ? other.high[k] : high[k];
    }
  }
  /// Half the surface; 0 where it is empty.
  [[nodiscard]] float half_area() const noexcept {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
  }
};

/// The map v(x) = (x - origin) 2^exponent. A quarter of each coordinate is taken first, so that no difference overflows.
struct Space {
  double quarter_origin[3] = {};
  double scale = 4;  ///< 2^(exponent + 2)
  int exponent = 0;
  /// Whether the map works in floats too, of floats, with these; see `coordinate_of`. The fourth number lets vectors be loaded.
  bool is_narrow = false;
  float narrow_origin[4] = {}, narrow_scale = 0;

  /// Of shapes in T, about an origin whose coordinates are numbers of T. The exponent is at least -1024, at most 898.
  template <Real T>
  [[nodiscard]] static Space about(const std::array<double, 3>& origin, int exponent) noexcept {
    Space space;
    space.exponent = exponent;
    space.scale = power_of_two(exponent + 2);
    space.is_narrow = sizeof(T) < sizeof(double) && exponent >= -100 && exponent <= 100;
    for (int k = 0; k < 3; ++k) {
      const double size = __builtin_fabs(origin[k]);
      space.quarter_origin[k] = 0.25 * origin[k];
      space.is_narrow = space.is_narrow && (size == 0 || size >= 0x1p-100);
    }
    if (!space.is_narrow) return space;
    for (int k = 0; k < 3; ++k) space.narrow_origin[k] = static_cast<float>(origin[k]);
    space.narrow_scale = static_cast<float>(power_of_two(exponent));
    return space;
  }

  /// Errs by at most 2^-51 |v| + 2^-120, in every mode: the subtraction by 2^-52 |v|; an underflow, a flush or a subnormal
  /// double read as zero by 3 * 2^-1022 times a scale of at most 2^900.
  [[nodiscard]] double coordinate(double x, int axis) const noexcept { return (0.25 * x - quarter_origin[axis]) * scale; }
  /// As a float; infinite where it is too great for one. From a normal float or zero, where `is_narrow`, by two operations in
  /// floats: it errs by at most 2^-23 |v| for the subtraction, which does not underflow, as an origin is zero or so great that
  /// all numbers near it are multiples of 2^-124, and by 2^-126 for an underflow of the product. Where the subtraction
  /// overflows, which some modes round to the greatest float, it is above 2^27 at least.
  [[nodiscard]] float coordinate_of(float x, int axis) const noexcept {
    if (is_narrow && !numeric::is_subnormal(x)) return (x - narrow_origin[axis]) * narrow_scale;
    return static_cast<float>(coordinate(to_double(x), axis));
  }
  [[nodiscard]] float coordinate_of(double x, int axis) const noexcept { return static_cast<float>(coordinate(x, axis)); }
  /// A length; errs by 2^-120.
  [[nodiscard]] double length(double x) const noexcept { return 0.25 * x * scale; }
};

/// A float at most (at least) as great as every real number within `error` of v, for error >= 2^-51 |v| + 2^-119. The
/// conversion errs by 2^-23 of its argument, the sums by far less than 2^-24 |v|: 2^-22 |v| pays for both. What comes out
/// subnormal lies between the least normal numbers.
[[nodiscard]] inline float below(double v, double error) noexcept {
  const double size = __builtin_fabs(v);
  const float bound = static_cast<float>(v - (0x1p-22 * size + 2 * error));
  return numeric::magnitude_bits(bound) < 0x00800000u ? -0x1p-126f : bound;
}
[[nodiscard]] inline float above(double v, double error) noexcept {
  return -below(-v, error);
}

template <Real T>
[[nodiscard]] inline Box box_of(const Space& space, const Triangle<T>& t) noexcept {
  Box box;
  const T corners[3][3] = {{t.a.x, t.b.x, t.c.x}, {t.a.y, t.b.y, t.c.y}, {t.a.z, t.b.z, t.c.z}};
  for (int k = 0; k < 3; ++k) {
    double low = space.coordinate(to_double(corners[k][0]), k), high = low;
    for (int i = 1; i < 3; ++i) {
      const double v = space.coordinate(to_double(corners[k][i]), k);
      low = v < low ? v : low;
      high = v > high ? v : high;
    }
    box.low[k] = below(low, 0x1p-51 * __builtin_fabs(low) + 0x1p-118);
    box.high[k] = above(high, 0x1p-51 * __builtin_fabs(high) + 0x1p-118);
  }
  return box;
}

template <Real T>
[[nodiscard]] inline Box box_of(const Space& space, const Sphere<T>& s) noexcept {
  Box box;
  const double r = space.length(to_double(s.radius));
  const T center[3] = {s.center.x, s.center.y, s.center.z};
  for (int k = 0; k < 3; ++k) {
    const double c = space.coordinate(to_double(center[k]), k), error = 0x1p-50 * (__builtin_fabs(c) + r) + 0x1p-118;
    box.low[k] = below(c - r, error);
    box.high[k] = above(c + r, error);
  }
  return box;
}

}  // namespace graze::scene
