// The exact stage of point and implicit surface: the sign of f(p) over integers.
#include "graze/implicit.hpp"

#include <algorithm>
#include <array>

#include "exact/scaled.hpp"
#include "graze/numeric/bits.hpp"

namespace graze::exact {
namespace {

using numeric::dyadic;

/// The sign of the sum of coefficient[i] * coordinate[i], i < N <= 4: below 2^(2w+2), so 2 K limbs hold it.
template <std::size_t N>
Sign sign_of_dot(const std::array<Dyadic, N>& coefficients, const std::array<Dyadic, N>& coordinates) noexcept {
  Extent first, second;
  for (std::size_t i = 0; i < N; ++i) {
    first.include(coefficients[i]);
    second.include(coordinates[i]);
  }
  return with_tier(std::max(first.width(), second.width()), [&]<int K>() {
    Integer<2 * K> sum = numeric::integer<2 * K>({}, 0);
    for (std::size_t i = 0; i < N; ++i) {
      sum = sum + numeric::integer<K>(coefficients[i], first.low) * numeric::integer<K>(coordinates[i], second.low);
    }
    return static_cast<Sign>(sum.sign());
  });
}

constexpr Dyadic one{1, 0, false};
constexpr Side non_finite{Status::non_finite, Sign::zero};

}  // namespace

template <Real T>
Side side(const Vec2<T>& point, const Line<T>& line) noexcept {
  using numeric::is_finite;
  if (!is_finite(point) || !is_finite(line.a) || !is_finite(line.b) || !is_finite(line.c)) return non_finite;
  return {Status::ok,
          sign_of_dot<3>({dyadic(line.a), dyadic(line.b), dyadic(line.c)}, {dyadic(point.x), dyadic(point.y), one})};
}

template <Real T>
Side side(const Vec3<T>& point, const Plane<T>& plane) noexcept {
  using numeric::is_finite;
  const auto& [a, b, c, d] = plane;
  if (!is_finite(point) || !is_finite(a) || !is_finite(b) || !is_finite(c) || !is_finite(d)) return non_finite;
  return {Status::ok, sign_of_dot<4>({dyadic(a), dyadic(b), dyadic(c), dyadic(d)},
                                     {dyadic(point.x), dyadic(point.y), dyadic(point.z), one})};
}

template <Real T>
Side side(const Vec3<T>& point, const Sphere<T>& sphere) noexcept {
  using numeric::is_finite;
  if (!is_finite(point) || !is_finite(sphere.center) || !is_finite(sphere.radius)) return non_finite;
  if (numeric::is_negative(sphere.radius)) return {Status::negative_radius, Sign::zero};
  const DyadicVec3 p = dyadic(point), center = dyadic(sphere.center);
  const Dyadic radius = dyadic(sphere.radius);
  Extent extent;
  extent.include(p);
  extent.include(center);
  extent.include(radius);
  return with_tier(extent.width(), [&]<int K>() -> Side {
    const IntegerVec3<K> l = integer_vec3<K>(p, extent.low) - integer_vec3<K>(center, extent.low);
    const Integer<K> r = numeric::integer<K>(radius, extent.low);
    return {Status::ok, static_cast<Sign>((dot(l, l) - r * r).sign())};
  });
}

template Side side(const Vec2<float>&, const Line<float>&) noexcept;
template Side side(const Vec2<double>&, const Line<double>&) noexcept;
template Side side(const Vec3<float>&, const Plane<float>&) noexcept;
template Side side(const Vec3<double>&, const Plane<double>&) noexcept;
template Side side(const Vec3<float>&, const Sphere<float>&) noexcept;
template Side side(const Vec3<double>&, const Sphere<double>&) noexcept;

}  // namespace graze::exact
