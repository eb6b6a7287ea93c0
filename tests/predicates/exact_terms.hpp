// What the filters approximate, exactly, and how much of a bound an error takes.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/case.hpp"
#include "oracle/gmp_vector.hpp"

namespace graze::test {

/// value * 2^unit.
struct ExactNumber {
  mpz_class value = 0;
  int unit = 0;
};

/// x in units of 2^unit, which divides it.
[[nodiscard]] inline mpz_class in_units(double x, int unit) {
  mpz_class value;
  oracle::gmp::scale(value, oracle::gmp::dyadic(x), unit);
  return value;
}

/// |computed - exact| / bound, at most 1 only where the exact quotient is; infinity where a number is not finite or the bound
/// is zero and the error is not.
[[nodiscard]] inline double share_of(double bound, double computed, const ExactNumber& exact) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!std::isfinite(bound) || !std::isfinite(computed)) return infinity;
  const int unit = std::min(oracle::gmp::common_unit({oracle::gmp::dyadic(bound), oracle::gmp::dyadic(computed)}), exact.unit);
  const mpz_class error = abs(in_units(computed, unit) - (exact.value << static_cast<mp_bitcnt_t>(exact.unit - unit)));
  const mpz_class most = in_units(bound, unit);
  if (sgn(error) == 0) return 0;
  if (sgn(most) == 0) return infinity;
  const double share = mpq_class(error, most).get_d();
  return error <= most ? std::min(share, 1.0) : std::max(share, std::nextafter(1.0, 2.0));
}

/// The determinants of TriangleTerms.
struct ExactTriangle {
  ExactNumber determinant, u, v, distance;
};

template <Real T>
[[nodiscard]] ExactTriangle exact_terms(const fuzz::RayTriangle<T>& query) {
  using namespace oracle::gmp;
  const DyadicVector e = dyadic(query.ray.origin), d = dyadic(query.ray.direction);
  const DyadicVector a = dyadic(query.triangle.a), b = dyadic(query.triangle.b), c = dyadic(query.triangle.c);
  const int position = common_unit({e[0], e[1], e[2], a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
  const int direction = common_unit({d[0], d[1], d[2]});
  Vector start, along, corner, e1, e2, t, h, g;
  scale(along, d, direction);
  scale(corner, a, position);
  scale(e1, b, position);
  scale(e2, c, position);
  scale(t, e, position);
  subtract(e1, e1, corner);
  subtract(e2, e2, corner);
  subtract(t, t, corner);
  cross(h, along, e2);
  cross(g, t, e1);
  ExactTriangle exact;
  exact.determinant.unit = exact.u.unit = exact.v.unit = 2 * position + direction;
  exact.distance.unit = 3 * position;
  dot(exact.determinant.value, e1, h);
  dot(exact.u.value, t, h);
  dot(exact.v.value, along, g);
  dot(exact.distance.value, e2, g);
  return exact;
}

/// A, B, C and D = B^2 - A C.
struct ExactSphere {
  ExactNumber a, b, c, discriminant;
};

template <Real T>
[[nodiscard]] ExactSphere exact_terms(const fuzz::RaySphere<T>& query) {
  using namespace oracle::gmp;
  const DyadicVector e = dyadic(query.ray.origin), d = dyadic(query.ray.direction), c = dyadic(query.sphere.center);
  const Dyadic r = dyadic(query.sphere.radius);
  const int position = common_unit({e[0], e[1], e[2], c[0], c[1], c[2], r}), direction = common_unit({d[0], d[1], d[2]});
  Vector along, start, l;
  scale(along, d, direction);
  scale(start, e, position);
  scale(l, c, position);
  subtract(l, l, start);
  mpz_class radius;
  scale(radius, r, position);
  ExactSphere exact;
  exact.a.unit = 2 * direction;
  exact.b.unit = position + direction;
  exact.c.unit = 2 * position;
  exact.discriminant.unit = 2 * exact.b.unit;
  dot(exact.a.value, along, along);
  dot(exact.b.value, along, l);
  dot(exact.c.value, l, l);
  exact.c.value -= radius * radius;
  exact.discriminant.value = exact.b.value * exact.b.value - exact.a.value * exact.c.value;
  return exact;
}

/// f of an implicit surface at a point.
template <Real T>
[[nodiscard]] ExactNumber exact_value(const fuzz::PointSphere<T>& query) {
  return exact_terms(fuzz::RaySphere<T>{{query.point, {1, 0, 0}}, query.sphere}).c;
}
template <Real T>
[[nodiscard]] ExactNumber exact_value(const fuzz::PointPlane<T>& query) {
  using namespace oracle::gmp;
  const auto& [a, b, c, d] = query.plane;
  const DyadicVector n = dyadic(Vec3<T>{a, b, c}), p = dyadic(query.point);
  const int normal = common_unit({n[0], n[1], n[2]}), position = common_unit({p[0], p[1], p[2]});
  const int unit = std::min(normal + position, common_unit({dyadic(d)}));
  Vector normal_vector, point;
  scale(normal_vector, n, normal);
  scale(point, p, position);
  ExactNumber exact{0, unit};
  dot(exact.value, normal_vector, point);
  exact.value <<= static_cast<mp_bitcnt_t>(normal + position - unit);
  exact.value += in_units(static_cast<double>(d), unit);
  return exact;
}
template <Real T>
[[nodiscard]] ExactNumber exact_value(const fuzz::PointLine<T>& query) {
  const auto& [a, b, c] = query.line;
  return exact_value(fuzz::PointPlane<T>{{query.point.x, query.point.y, 0}, {a, b, 0, c}});
}

}  // namespace graze::test
