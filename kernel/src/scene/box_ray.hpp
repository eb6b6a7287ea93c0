// A ray in box space, and the test of boxes that never rejects one which the exact ray meets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "numeric/dyadic.hpp"
#include "scene/node.hpp"
#include "scene/space.hpp"

namespace graze::scene {

/// The exact ray is X(tau) = E + tau D with E = v(e) and D = d 2^-x, max |D| in [1, 2); t = tau 2^-(exponent + x). It is
/// followed from X(tau0), by s = tau - tau0, where tau0 is any number that is at most the tau of every hit: so s >= 0 there,
/// and a distant origin does not cost the floats their precision.
///
/// What is computed, with u = 2^-23, which bounds one float operation's relative error in every rounding mode:
///   F, a double within f of X(tau0), f = 2^-50 (|E| + |tau0 D|) + 2^-110 |tau0| + 2^-100;
///   R, a float within 1.01 u of 1 / D, or +-2^60 where |D| < 2^-60;
///   for a plane at p, the one met first, n = p R - (F R + g |R|), for the one met last m = p R - (F R - g |R|),
///   g = 2^-21 |F| + 2 f + 2^-90, and 2^-58 (1 + max |F|) more where |D| < 2^-60;
///   the box is met if max(n, 0) <= min(m, s_high) (1 + 2^-20), over the three axes.
/// Why no box is lost. Let the ray meet the box at s >= 0, so that for each axis nu <= s <= mu, where nu and mu are the
/// parameters (p - X(tau0)) / D of its planes.
///  - |D| >= 2^-60. With G the exact X(tau0), p R - G R = nu (1 + a), |a| <= 1.01 u. The product p R errs by u |p R| <= u (|p -
///    G| + |G|) |R|, or not at all with FMA; the offset, a float made from doubles, by 1.1 u (|F| + g) |R|; replacing G by F by
///    f |R|. All terms with |F| or |R| alone are below g |R| / 1.5: (2.1 u + 2^-50) |F| < 0.55 2^-21 |F|, f < 2 f / 1.5, and
///    what is flushed or underflows, 3 * 2^-126, is below 2^-90 / 2 * |R| / 1.5, as |R| >= 1/2. So before its last rounding n
///    is at most nu (1 + 1.01 u + 1.01 u (1 + u)) where nu >= 0, and negative where nu < 0; after it n <= nu (1 + 3.1 u) or n
///    <= 0. Likewise m >= mu (1 - 3.1 u), and m >= 2^-92 (so that it is not flushed), as mu >= 0. Hence
///    n <= s (1 + 3.1 u) <= m (1 + 6.3 u), and with its own rounding m (1 + 8 u) is above that.
///  - |D| < 2^-60. On an axis j with |D_j| >= 1, s <= |X_j| + |G_j| <= 1.01 + max |F| + f: taking D = 1 / R there moves the ray
///    by at most s 2^-59 on this axis, for which 2^-58 (1 + max |F|) pays. Then the above holds for the moved ray.
///  - s_high is at least (1 + 2^-20) times the greatest s that is still of interest.
/// Nothing overflows: |p| <= 1.01, |F| <= 2^62, |R| <= 2^60, so |n|, |m| < 2^124. Rays for which the bounds of E fail (|E| >
/// 2^40, infinite, NaN) take R = 0, n = 0, m = the largest float: they meet every box.
///
/// All inputs of the float operations are normal or zero, so denormals-are-zero changes nothing.
struct BoxRay {
  /// Of three axes; the fourth number lets vectors be stored.
  float reciprocal[4], near_offset[4], far_offset[4];
  /// Of the planes met first and last, where a node has them: offsets in its bounds.
  std::uint32_t near_row[4] = {row(0), row(1), row(2)}, far_row[4] = {row(3), row(4), row(5)};
  float high = std::numeric_limits<float>::max();  ///< s_high
  double start = 0;                                ///< tau0
  int time_exponent = 0;                           ///< tau = t 2^time_exponent
  bool is_blind = false;                           ///< meets every box

  static constexpr float slack = 0x1p-20f;
  /// Rays whose origin is no farther off in box space are followed from there: the floats lose little.
  static constexpr double near_by = 4;
  /// Of 2 f + 2^-90 what is the same for all axes.
  [[nodiscard]] static double least_error(double start) noexcept {
    return 0x1p-109 * __builtin_fabs(start) + (0x1p-99 + 0x1p-90);
  }
  [[nodiscard]] static constexpr std::uint32_t row(int i) noexcept { return static_cast<std::uint32_t>(i * width); }

  void set(int axis, float r, float near, float far) noexcept {
    reciprocal[axis] = r;
    near_offset[axis] = near;
    far_offset[axis] = far;
    near_row[axis] = row(r < 0 ? axis + 3 : axis);
    far_row[axis] = row(r < 0 ? axis : axis + 3);
  }

  /// t 2^time_exponent, within 2^-52 of it; 0, subnormal or infinite where it is.
  [[nodiscard]] double tau(double t) const noexcept {
    if (time_exponent >= -1000 && time_exponent <= 1000) return t * power_of_two(time_exponent);
    const int first = std::clamp(time_exponent / 2, -1000, 1000), second = std::clamp(time_exponent - first, -1000, 1000);
    const int third = std::clamp(time_exponent - first - second, -1000, 1000);
    return t * power_of_two(first) * power_of_two(second) * power_of_two(third);
  }

  /// At most the tau of t_min. Every hit has |tau| <= 2^41, so clamping at 2^60 loses none; and first at 2^100, since an
  /// infinite one has no error to subtract. A subnormal t_min may be read as 0, which is 2^-1022 off.
  template <Real T>
  [[nodiscard]] double first_tau(const Ray<T>& ray) const noexcept {
    if (numeric::magnitude_bits(ray.t_min) == 0) return 0;
    const double first = std::clamp(tau(to_double(ray.t_min)), -0x1p100, 0x1p100);
    const double error = 0x1p-50 * __builtin_fabs(first) + tau(0x1p-1021) + 0x1p-1000;
    return std::clamp(first - error, -0x1p60, 0x1p60);
  }
  template <Real T>
  void end_with(const Ray<T>& ray) noexcept {
    if (!numeric::is_finite(ray.t_max)) return;
    // A subnormal t_max may be read as 0.
    const double t_max = to_double(ray.t_max);
    end_at(__builtin_fabs(t_max) < 0x1p-1021 ? 0x1p-1020 : t_max);
  }

  /// From now on boxes that are entered after t are not met. t is normal, zero or infinite.
  void end_at(double t) noexcept {
    if (is_blind) return;
    const double end = tau(t), size = __builtin_fabs(end) + __builtin_fabs(start);
    const double s = end - start + (0x1p-48 * size + 0x1p-90);
    // In float with its rounding, and the slack of the test itself.
    const double s_high = s < 0 ? s : s * (1 + 0x1p-18);
    high = s_high < 0x1p126 ? static_cast<float>(s_high) : std::numeric_limits<float>::max();
  }
};

/// d 2^-x with x such that the largest component is in [1, 2); errs by 2^-52 of a component and 2^-120, and by nothing in the
/// largest.
struct Direction {
  double d[3];
  int exponent;  ///< x
};

template <Real T>
[[nodiscard]] inline Direction normalised(const Vec3<T>& v) noexcept {
  const T components[3] = {v.x, v.y, v.z};
  double d[3];
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    d[k] = to_double(components[k]);
    largest = std::max(largest, __builtin_fabs(d[k]));
  }
  if (largest >= 0x1p-900 && largest <= 0x1p900) {
    const int x = exponent_of(largest);
    const double scale = power_of_two(-x);
    return {{d[0] * scale, d[1] * scale, d[2] * scale}, x};
  }
  // From the bits: the components may be subnormal, or their scale out of reach.
  const numeric::Dyadic bits[3] = {numeric::dyadic(v.x), numeric::dyadic(v.y), numeric::dyadic(v.z)};
  int x = -5000;
  for (const numeric::Dyadic& b : bits) x = b.is_zero() ? x : std::max(x, b.top() - 1);
  Direction out{{0, 0, 0}, x};
  for (int k = 0; k < 3; ++k) {
    if (bits[k].is_zero() || bits[k].top() - x < -150) continue;
    const double size = static_cast<double>(static_cast<std::int64_t>(bits[k].mantissa)) * power_of_two(bits[k].exponent - x);
    out.d[k] = bits[k].negative ? -size : size;
  }
  return out;
}

/// `root` holds every shape. The ray is valid.
template <Real T>
[[nodiscard]] inline BoxRay box_ray(const Space& space, const Box& root, const Ray<T>& ray) noexcept {
  const T origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const Direction direction = normalised(ray.direction);
  BoxRay out;
  out.time_exponent = space.exponent + direction.exponent;
  double e[3];
  double far = 0;
  for (int k = 0; k < 3; ++k) {
    e[k] = space.coordinate(to_double(origin[k]), k);
    far = std::max(far, __builtin_fabs(e[k]));
  }
  // A difference that overflows compares as false.
  if (!(far <= 0x1p40)) {
    out.is_blind = true;
    for (int k = 0; k < 3; ++k) {
      out.reciprocal[k] = 0;
      out.near_offset[k] = 0;
      out.far_offset[k] = -std::numeric_limits<float>::max();
    }
    return out;
  }
  double r[3];
  for (int k = 0; k < 3; ++k) r[k] = 1 / direction.d[k];
  double start = out.first_tau(ray);
  if (far > BoxRay::near_by || start != 0) {
    for (int k = 0; k < 3; ++k) {
      const double d = direction.d[k];
      if (__builtin_fabs(d) < 0x1p-30) continue;
      // The product errs by less than the margin, so this is at most the tau at which the ray enters the root.
      const double plane = d > 0 ? root.low[k] : root.high[k];
      const double entry = (plane - e[k]) * r[k] - 0x1p-45 * (1 + __builtin_fabs(e[k])) * __builtin_fabs(r[k]);
      start = std::max(start, std::min(entry, 0x1p60));
    }
  }
  out.start = start;
  double f[3];
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    f[k] = e[k] + start * direction.d[k];
    largest = std::max(largest, __builtin_fabs(f[k]));
  }
  for (int k = 0; k < 3; ++k) {
    const double d = direction.d[k];
    const double error = 0x1p-49 * (__builtin_fabs(e[k]) + __builtin_fabs(start * d)) + BoxRay::least_error(start);
    double g = 0x1p-21 * __builtin_fabs(f[k]) + error, reciprocal_of_d = r[k];
    if (__builtin_fabs(d) < 0x1p-60) {
      reciprocal_of_d = (numeric::bits_of(d) & numeric::sign_bit<double>) != 0 ? -0x1p60 : 0x1p60;
      g += 0x1p-58 * (1 + largest);
    }
    const auto reciprocal = static_cast<float>(reciprocal_of_d);
    const double exact = reciprocal, size = __builtin_fabs(exact);
    out.set(k, reciprocal, static_cast<float>(f[k] * exact + g * size), static_cast<float>(f[k] * exact - g * size));
  }
  out.end_with(ray);
  return out;
}

}  // namespace graze::scene
