// t, u and v of a hit that the filter has found inside the face, rounded from double-double (double) or double (float).
#include "graze/triangle.hpp"
#include "rounding/candidate.hpp"

namespace graze::rounding {
namespace {

using numeric::Pair;
using numeric::PairVector;
using predicates::TriangleTerms;

/// The determinants of TriangleTerms, better; the errors are bounded by TriangleTerms' own times `relative_error`.
struct Determinants {
  Pair determinant, u, v, distance;
  double relative_error;
};

/// As they stand.
Determinants determinants(const Ray<float>&, const Triangle<float>&, const TriangleTerms& terms) noexcept {
  return {{terms.determinant, 0}, {terms.u, 0}, {terms.v, 0}, {terms.distance, 0}, 1};
}

/// In double-double: the differences are exact, a monomial passes through two products and four sums of at most 4 * 2^-106 each,
/// dropped low products included 6 * 7 * 4 * 2^-106 m in all; TriangleTerms' bounds are 44 * 2^-52 m, and 2^-50 times that is 4 times as much.
Determinants determinants(const Ray<double>& ray, const Triangle<double>& triangle, const TriangleTerms&) noexcept {
  using namespace numeric;
  const Vector a = vector(triangle.a), d = vector(ray.direction);
  const PairVector e1 = exact_difference(vector(triangle.b), a), e2 = exact_difference(vector(triangle.c), a);
  const PairVector t = exact_difference(vector(ray.origin), a);
  const PairVector h = cross(d, e2), g = cross(t, e1);
  return {normalised(dot(e1, h)), normalised(dot(t, h)), normalised(dot(d, g)), normalised(dot(e2, g)), 0x1p-50};
}

/// n / d with |errors| n_error and d_error: the quotient errs by (n_error + |q| d_error) / |d| to first order, the division itself by
/// 2^-100 (a single double's by 2^-52).
template <Real T>
Candidate quotient(Pair n, double n_error, Pair d, double d_error, double inverse) noexcept {
  constexpr double division = sizeof(T) < sizeof(double) ? 0x1p-52 : 0x1p-100;
  const Pair q = sizeof(T) < sizeof(double) ? Pair{n.hi / d.hi, 0} : n / d;
  const double size = numeric::magnitude(q.hi);
  return {q, (n_error + size * d_error) * inverse + size * division};
}

}  // namespace

template <Real T>
TriangleHit<T> face(const Ray<T>& ray, const Triangle<T>& triangle, const TriangleTerms& terms) noexcept {
  using numeric::magnitude;
  if (!numeric::rounds_to_nearest()) return exact::intersect(ray, triangle);
  const Determinants r = determinants(ray, triangle, terms);
  const double k = r.relative_error;
  const double size = magnitude(r.determinant.hi), error = k * terms.determinant_error;
  // With the determinant known to 2^-10, terms of second order are below 2^-9 of those of first.
  const double inverse = (1 + 0x1p-8) / size;
  const auto divide = [&](Pair n, double n_error) { return quotient<T>(n, k * n_error, r.determinant, error, inverse); };
  TriangleHit<T> hit;
  const bool is_certain = size > 0x1p10 * error && rounds_certainly(divide(r.distance, terms.distance_error), hit.t) &&
                          rounds_certainly(divide(r.u, terms.u_error), hit.u) &&
                          rounds_certainly(divide(r.v, terms.v_error), hit.v);
  if (!is_certain) return exact::intersect(ray, triangle);
  hit.kind = TriangleKind::face;
  hit.facing = terms.determinant > 0 ? Facing::front : Facing::back;
  hit.t_end = hit.t;
  return hit;
}

template TriangleHit<float> face(const Ray<float>&, const Triangle<float>&, const TriangleTerms&) noexcept;
template TriangleHit<double> face(const Ray<double>&, const Triangle<double>&, const TriangleTerms&) noexcept;

}  // namespace graze::rounding
