// t, u and v of a hit that the filter has found inside the face, rounded from double-double (double) or double (float).
#include "graze/triangle.hpp"
#include "rounding/quotients.hpp"

namespace graze::rounding {
namespace {

using numeric::PairLanes;
using predicates::TriangleTerms;

Quotients quotients(const Ray<float>&, const Triangle<float>&, const TriangleTerms<double>& terms) noexcept {
  const double d = terms.whole;
  return with_errors(Lanes{terms.distance / d, terms.u / d, terms.v / d, 0}, Lanes{}, d, bounds_of(terms), 1, quotient_error);
}

/// The determinants of TriangleTerms in double-double, from differences that are exact.
Quotients quotients(const Ray<double>& ray, const Triangle<double>& triangle, const TriangleTerms<double>& terms) noexcept {
  using namespace numeric;
  const Lanes a = lanes(triangle.a), d = lanes(ray.direction);
  const PairLanes e1 = two_difference(lanes(triangle.b), a), e2 = two_difference(lanes(triangle.c), a);
  const PairLanes t = two_difference(lanes(ray.origin), a);
  const PairLanes h = cross(d, e2), g = cross(t, e1);
  const PairLanes n = normalised(sums(e2 * g, t * h, d * g, e1 * h));
  const PairLanes determinant{__builtin_shufflevector(n.hi, n.hi, 3, 3, 3, 3), __builtin_shufflevector(n.lo, n.lo, 3, 3, 3, 3)};
  const PairLanes q = n / determinant;
  return with_errors(q.hi, q.lo, determinant.hi[0], bounds_of(terms), pair_relative, pair_quotient_error);
}

}  // namespace

template <Real T>
TriangleHit<T> face(const Ray<T>& ray, const Triangle<T>& triangle, const TriangleTerms<double>& terms) noexcept {
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, triangle);
  const Quotients q = quotients(ray, triangle, terms);
  TriangleHit<T> hit;
  return round_certainly(q, bounds_of(terms), hit) ? hit : exact::intersect(ray, triangle);
}

template TriangleHit<float> face(const Ray<float>&, const Triangle<float>&, const TriangleTerms<double>&) noexcept;
template TriangleHit<double> face(const Ray<double>&, const Triangle<double>&, const TriangleTerms<double>&) noexcept;

}  // namespace graze::rounding
