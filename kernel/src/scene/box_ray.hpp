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
///  - F, within f of X(tau0), f = 2^-50 (|E| + |tau0 D|) + 2^-110 |tau0| + 2^-100, and F', a float within u |F| + 2^-126 of it.
///    Either F is a double; or, of floats followed from their origin, X(0) itself, of which two operations in floats make F'
///    (Space::coordinate_of), which do not overflow where F' is as near by as that asks;
///  - R, a float within 1.01 u of 1 / D, or +-2^60 where that float is greater; and R+ = R (1 + 2^-19), rounded;
///  - g = 2^-20 |F'| + e, with e = 2^-49 (|E| + |tau0 D|) + 2^-109 |tau0| + 2^-89, or 2^-89 where the ray is followed from
///    its origin, and 2^-58 (1 + max |F'|) more where |R| = 2^60 took a greater one's place;
///  - for a plane at p, the one met first, n = p R - (F' R + g |R|), for the one met last m = p R+ - (F' R+ - g |R+|), where
///    only the products with p may be fused;
///  - the box is met if max(n, 0) <= min(m, s_high), over the three axes.
/// Why no box is lost. Let the ray meet the box at s >= 0, so that for each axis nu <= s <= mu, where nu and mu are the
/// parameters (p - X(tau0)) / D of its planes.
///  - R is 1 / D. With G the exact X(tau0), p R - G R = nu (1 + a), |a| <= 1.01 u. The product p R errs by u |p R|, which is
///    at most u (|p - G| + |G|) |R|, or not at all if fused; F' for G by (u |F| + f) |R|; the offset by u |F' R| in its
///    product and u (|F' R| + 1.01 g |R|) in its sum. All terms with |F| or |R| alone are below g |R| / 1.5: the four of them
///    with u |F| come to less than 4.1 u |F| < 0.52 2^-20 |F|; 1.65 f < e, but where the ray is followed from its origin for
///    2^-50 |E|, which is next to nothing beside u |F|, as E = F there; g and its product with |R| err by 5 u of themselves;
///    and what is flushed or underflows, 6 * 2^-126 (1 + |R|), is below 2^-89 / 8 * |R|, as |R| >= 1/2. So before its last
///    rounding n is at most nu (1 + 1.01 u + 1.01 u (1 + u)) where nu >= 0, and negative where nu < 0; after it
///    n <= nu (1 + 3.1 u) or n <= 0. Likewise m with R+, which is 1 / D times at least 1 + 2^-19 - 2.1 u:
///    m >= mu (1 + 2^-19 - 4.2 u) > mu (1 + 2^-20), and m >= 2^-92 (so that it is not flushed), as mu >= 0. Hence
///    n <= s (1 + 3.1 u) <= m.
///  - |R| = 2^60 in a greater one's place: |D| < 2^-60 (1 + 2 u). On an axis j with |D_j| >= 1, s <= |X_j| + |G_j|, which is
///    at most 1.01 + max |F| + f: taking D = 1 / R moves the ray by at most s 2^-59 on this axis, for which
///    2^-58 (1 + max |F'|) pays. Then the above holds for the moved ray.
///  - s_high is at least (1 + 2^-20) times the greatest s that is still of interest, which is more than n.
/// Nothing overflows: |p| <= 1.01, |F| <= 2^62, |R+| <= 2^61, so |n|, |m| < 2^124. Rays for which the bounds of E fail
/// (|E| > 2^40, infinite) take R = R+ = 0, n = 0, m = the largest float: they meet every box.
///
/// All inputs of the boxes' float operations are normal or zero, so denormals-are-zero changes nothing.
struct BoxRay {
  /// Of three axes; the fourth number lets vectors be stored.
  float reciprocal[4], far_reciprocal[4], near_offset[4], far_offset[4];
  /// Of the planes met first and last, where a node has them: offsets in its bounds.
  std::uint32_t near_row[4], far_row[4];
  float high = std::numeric_limits<float>::max();  ///< s_high
  double reach = 0, reach_offset = high;           ///< s_high = t reach + reach_offset
  bool is_blind = false;                           ///< meets every box

  static constexpr float slack = 0x1p-19f;  ///< R+ = R (1 + slack)
  /// Rays whose origin is no farther off in box space are followed from there: the floats lose little.
  static constexpr float near_by = 4;
  /// Axes of greater reciprocals are taken for perpendicular to the ray, with this one.
  static constexpr float steepest = 0x1p60f;
  /// e where the ray is followed from its origin, and what is the same for all axes of its part for tau0 otherwise.
  static constexpr float least_error = 0x1p-89f;
  [[nodiscard]] static double least_error_at(double start) noexcept { return 0x1p-109 * __builtin_fabs(start) + least_error; }
  [[nodiscard]] static constexpr std::uint32_t row(int i) noexcept { return static_cast<std::uint32_t>(i * width); }

  void set(int axis, float r, float far_r, float near, float far) noexcept {
    reciprocal[axis] = r;
    far_reciprocal[axis] = far_r;
    near_offset[axis] = near;
    far_offset[axis] = far;
    near_row[axis] = row(r < 0 ? axis + 3 : axis);
    far_row[axis] = row(r < 0 ? axis : axis + 3);
  }

  /// Of tau = t 2^exponent, and tau0. With A the exact tau, in every mode t reach + reach_offset is at least A (1 + 2^-18) -
  /// 2^-50 |A| - tau0 (1 + 2^-18) + 2^-46 |tau0| + 2^-89, and as |A| <= s + |tau0| that is at least s (1 + 2^-18 - 2^-50) +
  /// 2^-90 for s = A - tau0 >= 0: rounded to float it has room for 2^-20. Beyond 2^+-1000 the ray is not
  /// shortened.
  void reach_from(int exponent, double start) noexcept {
    if (exponent < -1000 || exponent > 1000) return;
    reach = power_of_two(exponent) * (1 + 0x1p-18);
    reach_offset = 0x1p-45 * __builtin_fabs(start) + 0x1p-88 - start * (1 + 0x1p-18);
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
    const double s_high = t * reach + reach_offset;
    constexpr double most = std::numeric_limits<float>::max();
    high = static_cast<float>(s_high < most ? s_high : most);
  }
};

/// t 2^exponent, within 2^-52 of it; 0, subnormal or infinite where it is.
[[nodiscard]] inline double tau_of(double t, int exponent) noexcept {
  if (exponent >= -1000 && exponent <= 1000) return t * power_of_two(exponent);
  const int first = std::clamp(exponent / 2, -1000, 1000), second = std::clamp(exponent - first, -1000, 1000);
  const int third = std::clamp(exponent - first - second, -1000, 1000);
  return t * power_of_two(first) * power_of_two(second) * power_of_two(third);
}

/// At most the tau of t_min. Every hit has |tau| <= 2^41, so clamping at 2^60 loses none; and first at 2^100, since an
/// infinite one has no error to subtract. A subnormal t_min may be read as 0, which is 2^-1022 off.
template <Real T>
[[nodiscard]] inline double first_tau(const Ray<T>& ray, int exponent) noexcept {
  if (numeric::magnitude_bits(ray.t_min) == 0) return 0;
  const double first = std::clamp(tau_of(to_double(ray.t_min), exponent), -0x1p100, 0x1p100);
  const double error = 0x1p-50 * __builtin_fabs(first) + tau_of(0x1p-1021, exponent) + 0x1p-1000;
  return std::clamp(first - error, -0x1p60, 0x1p60);
}

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
  double e[3];
  float f[3], error[3];
  float far = 0;
  for (int k = 0; k < 3; ++k) {
    e[k] = space.coordinate(to_double(origin[k]), k);
    f[k] = space.coordinate_of(origin[k], k);
    error[k] = BoxRay::least_error;
    far = std::max(far, __builtin_fabsf(f[k]));
  }
  // A difference that overflows compares as false.
  if (!(far <= 0x1p40f)) {
    out.is_blind = true;
    for (int k = 0; k < 3; ++k) out.set(k, 0, 0, 0, -std::numeric_limits<float>::max());
    return out;
  }
  double r[3];
  for (int k = 0; k < 3; ++k) r[k] = 1 / direction.d[k];
  const int time_exponent = space.exponent + direction.exponent;
  double start = first_tau(ray, time_exponent);
  if (far > BoxRay::near_by || start != 0) {
    for (int k = 0; k < 3; ++k) {
      const double d = direction.d[k];
      if (__builtin_fabs(d) < 0x1p-30) continue;
      // The product errs by less than the margin, so this is at most the tau at which the ray enters the root.
      const double plane = d > 0 ? root.low[k] : root.high[k];
      const double entry = (plane - e[k]) * r[k] - 0x1p-45 * (1 + __builtin_fabs(e[k])) * __builtin_fabs(r[k]);
      start = std::max(start, std::min(entry, 0x1p60));
    }
    for (int k = 0; k < 3; ++k) {
      const double moved = start * direction.d[k];
      f[k] = static_cast<float>(e[k] + moved);
      error[k] = static_cast<float>(0x1p-49 * (__builtin_fabs(e[k]) + __builtin_fabs(moved)) + BoxRay::least_error_at(start));
    }
  }
  float largest = 0;
  for (const float x : f) largest = std::max(largest, __builtin_fabsf(x));
  for (int k = 0; k < 3; ++k) {
    float g = 0x1p-20f * __builtin_fabsf(f[k]) + error[k];
    auto reciprocal = static_cast<float>(r[k]);
    if (__builtin_fabsf(reciprocal) > BoxRay::steepest) {
      reciprocal = __builtin_copysignf(BoxRay::steepest, reciprocal);
      g += 0x1p-58f * (1 + largest);
    }
    const float far_reciprocal = reciprocal * (1 + BoxRay::slack);
    const float near = f[k] * reciprocal + g * __builtin_fabsf(reciprocal);
    const float far = f[k] * far_reciprocal - g * __builtin_fabsf(far_reciprocal);
    out.set(k, reciprocal, far_reciprocal, near, far);
  }
  out.reach_from(time_exponent, start);
  out.end_with(ray);
  return out;
}

}  // namespace graze::scene
