// The side of an implicit surface: the sign of a sum of products of the inputs, in integers.
#include "oracle/gmp_fraction.hpp"
#include "oracle/gmp_queries.hpp"
#include "oracle/gmp_status.hpp"
#include "oracle/gmp_vector.hpp"

namespace graze::oracle::gmp {
namespace {

[[nodiscard]] Side side_of_sign(int sign) {
  return {Status::ok, sign < 0 ? Sign::negative : (sign > 0 ? Sign::positive : Sign::zero)};
}

/// The sign of normal . point + constant.
[[nodiscard]] Side affine_side(const DyadicVector& normal, const DyadicVector& point, const Dyadic& constant) {
  thread_local Vector scaled_normal, scaled_point;
  thread_local mpz_class value;
  thread_local Fraction offset;
  const int normal_unit = common_unit({normal[0], normal[1], normal[2]});
  const int point_unit = common_unit({point[0], point[1], point[2]});
  scale(scaled_normal, normal, normal_unit);
  scale(scaled_point, point, point_unit);
  dot(value, scaled_normal, scaled_point);
  set_fraction(offset, constant, normal_unit + point_unit);
  value *= offset.den;
  value += offset.num;
  return side_of_sign(sgn(value));
}

}  // namespace

template <Real T>
Side Queries::side(const Vec2<T>& point, const Line<T>& line) {
  if (const Status status = status_of(point, line); status != Status::ok) return {status, Sign::zero};
  return affine_side({dyadic(line.a), dyadic(line.b), Dyadic{}}, {dyadic(point.x), dyadic(point.y), Dyadic{}}, dyadic(line.c));
}

template <Real T>
Side Queries::side(const Vec3<T>& point, const Plane<T>& plane) {
  if (const Status status = status_of(point, plane); status != Status::ok) return {status, Sign::zero};
  return affine_side({dyadic(plane.a), dyadic(plane.b), dyadic(plane.c)}, dyadic(point), dyadic(plane.d));
}

template <Real T>
Side Queries::side(const Vec3<T>& point, const Sphere<T>& sphere) {
  if (const Status status = status_of(point, sphere); status != Status::ok) return {status, Sign::zero};
  thread_local Vector scaled_point, from_center;
  thread_local mpz_class radius, value;
  const DyadicVector p = dyadic(point);
  const DyadicVector c = dyadic(sphere.center);
  const Dyadic r = dyadic(sphere.radius);
  const int unit = common_unit({p[0], p[1], p[2], c[0], c[1], c[2], r});
  scale(scaled_point, p, unit);
  scale(from_center, c, unit);
  scale(radius, r, unit);
  subtract(from_center, scaled_point, from_center);
  dot(value, from_center, from_center);
  mpz_submul(value.get_mpz_t(), radius.get_mpz_t(), radius.get_mpz_t());
  return side_of_sign(sgn(value));
}

template Side Queries::side(const Vec2<float>&, const Line<float>&);
template Side Queries::side(const Vec2<double>&, const Line<double>&);
template Side Queries::side(const Vec3<float>&, const Plane<float>&);
template Side Queries::side(const Vec3<double>&, const Plane<double>&);
template Side Queries::side(const Vec3<float>&, const Sphere<float>&);
template Side Queries::side(const Vec3<double>&, const Sphere<double>&);

}  // namespace graze::oracle::gmp
