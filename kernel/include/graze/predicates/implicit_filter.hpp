// f(p) of lines, planes and spheres in working precision, with proven error bounds.
#pragma once

#include "graze/answer.hpp"
#include "graze/predicates/sphere_filter.hpp"

namespace graze::predicates {

/// A value and a bound of its error. A NaN or an infinity in the input leaves the value or the bound NaN or infinite, and so
/// uncertain.
struct BoundedValue {
  double value, error;

  [[nodiscard]] bool is_certain() const noexcept { return numeric::magnitude(value) > error && error < 0x1p960; }
  [[nodiscard]] Sign sign() const noexcept { return value < 0 ? Sign::negative : Sign::positive; }
};

/// Underflow, flush-to-zero and denormals-are-zero: an input that is read as zero errs by at most 2^-1022 (float: 2^-126) times
/// the other factor, an operation that underflows by 2^-1022. This share of 1 + the factors' magnitudes covers all of them.
template <Real T>
inline constexpr double underflow_share = sizeof(T) < sizeof(double) ? 0x1p-125 : 0x1p-1018;

/// Each product is rounded once and passes through at most 2 sums: 3 unit of the sum of magnitudes, 4 with slack.
inline constexpr int line_error = 4;

template <Real T>
[[nodiscard]] inline BoundedValue value(const Vec2<T>& p, const Line<T>& line) noexcept {
  using numeric::magnitude;
  const double a = line.a, b = line.b, c = line.c, x = p.x, y = p.y;
  const double ax = a * x, by = b * y;
  const double size = magnitude(ax) + magnitude(by) + magnitude(c);
  const double inputs = 1 + magnitude(a) + magnitude(b) + magnitude(x) + magnitude(y);
  return {ax + by + c, line_error * numeric::unit * size + underflow_share<T> * inputs};
}

/// Each product is rounded once and passes through at most 3 sums: 4 unit of the sum of magnitudes, 5 with slack.
inline constexpr int plane_error = 5;

template <Real T>
[[nodiscard]] inline BoundedValue value(const Vec3<T>& p, const Plane<T>& plane) noexcept {
  using numeric::magnitude;
  const double a = plane.a, b = plane.b, c = plane.c, d = plane.d, x = p.x, y = p.y, z = p.z;
  const double ax = a * x, by = b * y, cz = c * z;
  const double size = magnitude(ax) + magnitude(by) + magnitude(cz) + magnitude(d);
  const double inputs = 1 + magnitude(a) + magnitude(b) + magnitude(c) + magnitude(x) + magnitude(y) + magnitude(z);
  return {ax + by + cz + d, plane_error * numeric::unit * size + underflow_share<T> * inputs};
}

/// As C in SphereTerms. A radius with a sign, or a size out of the filter's range, is left
/// uncertain.
template <Real T>
[[nodiscard]] inline BoundedValue value(const Vec3<T>& p, const Sphere<T>& sphere) noexcept {
  using namespace numeric;
  const Vector<double> l = vector<double>(p) - vector<double>(sphere.center);
  const auto r = static_cast<double>(sphere.radius);
  const double l2 = dot(l, l), r2 = r * r, s = magnitude_sum(l) + r;
  const bool is_bounded = is_ordinary<double, T>(s, s) && (bits_of(sphere.radius) & sign_bit<T>) == 0;
  return {l2 - r2, is_bounded ? sphere_c_error * unit * (l2 + r2) : std::numeric_limits<double>::infinity()};
}

}  // namespace graze::predicates
