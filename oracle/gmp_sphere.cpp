// Ray and sphere: the quadratic A t^2 - 2 B t + C in integers, its discriminant D = B^2 - A C and its roots (B -+ sqrt(D)) / A.
#include "oracle/gmp_queries.hpp"
#include "oracle/gmp_range.hpp"
#include "oracle/gmp_status.hpp"
#include "oracle/gmp_vector.hpp"

namespace graze::oracle::gmp {
namespace {

/// With positions in units of 2^p and the direction in units of 2^q, t is a root of the integer quadratic times 2^(p - q).
struct Quadratic {
  mpz_class a, b, c, discriminant;
  int exponent = 0;
  // Kept between calls for their limbs.
  Vector origin, direction, to_center;
  mpz_class radius;
};

template <Real T>
void set_quadratic(Quadratic& q, const Ray<T>& ray, const Sphere<T>& sphere) {
  const DyadicVector origin = dyadic(ray.origin);
  const DyadicVector direction = dyadic(ray.direction);
  const DyadicVector center = dyadic(sphere.center);
  const Dyadic radius = dyadic(sphere.radius);
  const int unit = common_unit({origin[0], origin[1], origin[2], center[0], center[1], center[2], radius});
  const int direction_unit = common_unit({direction[0], direction[1], direction[2]});
  q.exponent = unit - direction_unit;
  scale(q.origin, origin, unit);
  scale(q.direction, direction, direction_unit);
  scale(q.to_center, center, unit);
  scale(q.radius, radius, unit);
  subtract(q.to_center, q.to_center, q.origin);
  dot(q.a, q.direction, q.direction);
  dot(q.b, q.direction, q.to_center);
  dot(q.c, q.to_center, q.to_center);
  mpz_submul(q.c.get_mpz_t(), q.radius.get_mpz_t(), q.radius.get_mpz_t());
  mpz_mul(q.discriminant.get_mpz_t(), q.b.get_mpz_t(), q.b.get_mpz_t());
  mpz_submul(q.discriminant.get_mpz_t(), q.a.get_mpz_t(), q.c.get_mpz_t());
}

/// The sign of (the root of that sign) - bound, both multiplied by A and by the power of two that makes them integers.
[[nodiscard]] int compare_root(const Quadratic& q, int root_sign, const Dyadic& bound) {
  if (bound.mantissa == 0) return sign_of_root(q.b, root_sign, q.discriminant);
  thread_local Fraction limit;
  thread_local mpz_class rational, radicand;
  set_fraction(limit, bound, q.exponent);
  mpz_mul(rational.get_mpz_t(), q.b.get_mpz_t(), limit.den.get_mpz_t());
  mpz_submul(rational.get_mpz_t(), q.a.get_mpz_t(), limit.num.get_mpz_t());
  mpz_mul(radicand.get_mpz_t(), limit.den.get_mpz_t(), limit.den.get_mpz_t());
  mpz_mul(radicand.get_mpz_t(), radicand.get_mpz_t(), q.discriminant.get_mpz_t());
  return sign_of_root(rational, root_sign, radicand);
}

[[nodiscard]] bool root_in_range(const Quadratic& q, int root_sign, const Range& range) {
  return compare_root(q, root_sign, range.lower) >= 0 && (!range.bounded || compare_root(q, root_sign, range.upper) <= 0);
}

template <Real T>
[[nodiscard]] T nearest_root(const Quadratic& q, int root_sign) {
  thread_local Truncated truncated;
  truncate_root(truncated, q.b, root_sign, q.discriminant, q.a, q.exponent, kRoundingDigits<T>);
  return nearest<T>(truncated);
}

[[nodiscard]] Exact exact_root(const Quadratic& q, int root_sign) {
  Exact result;
  result.rational = rational({q.b, q.a}, q.exponent);
  result.root_sign = root_sign;
  if (root_sign != 0) result.radicand = rational({q.discriminant, q.a * q.a}, 2 * q.exponent);
  return result;
}

[[nodiscard]] OriginSide origin_side(const Quadratic& q) {
  const int sign = sgn(q.c);
  return sign < 0 ? OriginSide::inside : (sign > 0 ? OriginSide::outside : OriginSide::on);
}

/// Which of the two different roots lie in the range.
[[nodiscard]] Root roots_in_range(const Quadratic& q, const Range& range) {
  const bool first = root_in_range(q, -1, range);
  const bool second = root_in_range(q, +1, range);
  return first ? (second ? Root::both : Root::first) : (second ? Root::second : Root::none);
}

}  // namespace

template <Real T>
SphereHit<T> Queries::intersect(const Ray<T>& ray, const Sphere<T>& sphere, ExactSphere* exact) {
  SphereHit<T> hit;
  hit.status = status_of(ray, sphere);
  if (hit.status != Status::ok) {
    hit.kind = SphereKind::invalid;
    return hit;
  }
  thread_local Quadratic q;
  set_quadratic(q, ray, sphere);
  hit.origin = origin_side(q);
  const int discriminant = sgn(q.discriminant);
  if (discriminant < 0) return hit;

  const Range range = range_of(ray);
  int root_signs[2] = {-1, +1};
  if (discriminant == 0) {
    if (!root_in_range(q, 0, range)) return hit;
    hit.kind = SphereKind::tangent;
    hit.root = Root::both;
    root_signs[0] = 0;
  } else {
    hit.root = roots_in_range(q, range);
    if (hit.root == Root::none) return hit;
    hit.kind = SphereKind::secant;
    if (hit.root == Root::second) root_signs[0] = +1;
  }
  for (int i = 0; i < hit.count(); ++i) {
    hit.t[i] = nearest_root<T>(q, root_signs[i]);
    if (exact != nullptr) exact->t[i] = exact_root(q, root_signs[i]);
  }
  return hit;
}

template SphereHit<float> Queries::intersect(const Ray<float>&, const Sphere<float>&, ExactSphere*);
template SphereHit<double> Queries::intersect(const Ray<double>&, const Sphere<double>&, ExactSphere*);

}  // namespace graze::oracle::gmp
