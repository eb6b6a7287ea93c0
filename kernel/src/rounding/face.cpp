// t, u and v of a hit that the filter has found inside the face, rounded from double-double (double) or double (float).
#include "graze/triangle.hpp"
#include "numeric/double_double.hpp"
#include "rounding/candidate.hpp"

namespace graze::rounding {
namespace {

using numeric::Lanes;
using numeric::PairLanes;
using predicates::TriangleTerms;

/// t, u, v as hi + lo, each within its error.
struct Quotients {
  Lanes hi, lo;
  double t_error, u_error, v_error;
  bool are_bounded;
};

/// The error of n / d: (n_error + |q| d_error) / |d| to first order, and `division` |q| for the division itself. `relative`
/// scales the errors of the terms to those of the determinants used.
Quotients with_errors(const Lanes& hi, const Lanes& lo, double determinant, const TriangleTerms<double>& terms, double relative,
                      double division) noexcept {
  using numeric::magnitude;
  const double size = magnitude(determinant), scale = (1 + second_order) * relative / size;
  const auto error = [&](double q, double n_error) {
    return (n_error + magnitude(q) * terms.error) * scale + magnitude(q) * division;
  };
  return {hi,
          lo,
          error(hi[0], terms.distance_error),
          error(hi[1], terms.error),
          error(hi[2], terms.error),
          size > certainty * relative * terms.error};
}

Quotients quotients(const Ray<float>&, const Triangle<float>&, const TriangleTerms<double>& terms) noexcept {
  const double d = terms.whole;
  return with_errors(Lanes{terms.distance / d, terms.u / d, terms.v / d, 0}, Lanes{}, d, terms, 1, quotient_error);
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
  constexpr double relative = pair_determinant_error / (predicates::triangle_error * numeric::unit);
  return with_errors(q.hi, q.lo, determinant.hi[0], terms, relative, pair_quotient_error);
}

}  // namespace

template <Real T>
TriangleHit<T> face(const Ray<T>& ray, const Triangle<T>& triangle, const TriangleTerms<double>& terms) noexcept {
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, triangle);
  const Quotients q = quotients(ray, triangle, terms);
  TriangleHit<T> hit;
  const bool is_t_certain = rounds_certainly(q.hi[0], q.lo[0], q.t_error, hit.t);
  const bool is_u_certain = rounds_certainly(q.hi[1], q.lo[1], q.u_error, hit.u);
  const bool is_v_certain = rounds_certainly(q.hi[2], q.lo[2], q.v_error, hit.v);
  // One branch for all: & and not &&.
  const bool is_certain = q.are_bounded & is_t_certain & is_u_certain & is_v_certain;
  if (!is_certain) return exact::intersect(ray, triangle);
  hit.kind = TriangleKind::face;
  hit.facing = terms.is_front ? Facing::front : Facing::back;
  hit.t_end = hit.t;
  return hit;
}

template TriangleHit<float> face(const Ray<float>&, const Triangle<float>&, const TriangleTerms<double>&) noexcept;
template TriangleHit<double> face(const Ray<double>&, const Triangle<double>&, const TriangleTerms<double>&) noexcept;

}  // namespace graze::rounding
