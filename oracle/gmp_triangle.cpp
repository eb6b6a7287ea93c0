// Ray and triangle: Cramer's rule in integers. Where the determinant vanishes, the cases apart take over.
#include "oracle/gmp_triangle.hpp"

#include "oracle/gmp_queries.hpp"
#include "oracle/gmp_status.hpp"

namespace graze::oracle::gmp {
namespace {

template <Real T>
void set_triangle(IntegerTriangle& out, const Ray<T>& ray, const Triangle<T>& triangle) {
  const DyadicVector e = dyadic(ray.origin);
  const DyadicVector d = dyadic(ray.direction);
  const DyadicVector a = dyadic(triangle.a);
  const DyadicVector b = dyadic(triangle.b);
  const DyadicVector c = dyadic(triangle.c);
  const int unit = common_unit({e[0], e[1], e[2], a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
  const int direction_unit = common_unit({d[0], d[1], d[2]});
  out.exponent = unit - direction_unit;
  scale(out.origin, e, unit);
  scale(out.direction, d, direction_unit);
  scale(out.a, a, unit);
  scale(out.b, b, unit);
  scale(out.c, c, unit);
  subtract(out.edge_b, out.b, out.a);
  subtract(out.edge_c, out.c, out.a);
  cross(out.d_cross_edge_c, out.direction, out.edge_c);
  dot(out.determinant, out.edge_b, out.d_cross_edge_c);
}

/// The feature of the triangle that a point lies on, from the signs of its barycentric coordinates, none of them negative.
[[nodiscard]] TriangleKind feature(int u, int v, int w) {
  if (u == 0 && v == 0) return TriangleKind::vertex_a;
  if (v == 0 && w == 0) return TriangleKind::vertex_b;
  if (u == 0 && w == 0) return TriangleKind::vertex_c;
  if (v == 0) return TriangleKind::edge_ab;
  if (w == 0) return TriangleKind::edge_bc;
  if (u == 0) return TriangleKind::edge_ca;
  return TriangleKind::face;
}

template <Real T>
void round(TriangleHit<T>& hit, const CommonPart& part, int exponent) {
  hit.kind = part.kind;
  if (part.kind == TriangleKind::miss) return;
  hit.t = nearest<T>(part.t, exponent);
  if (hit.is_interval()) {
    hit.t_end = nearest<T>(part.t_end, exponent);
  } else {
    hit.t_end = hit.t;
    hit.u = nearest<T>(part.u, 0);
    hit.v = nearest<T>(part.v, 0);
  }
}

void set_exact(ExactTriangle& exact, const CommonPart& part, int exponent) {
  if (part.kind == TriangleKind::miss) return;
  exact.t.rational = rational(part.t, exponent);
  if (part.kind == TriangleKind::coplanar || part.kind == TriangleKind::degenerate) {
    exact.t_end.rational = rational(part.t_end, exponent);
  } else {
    exact.t_end = exact.t;
    exact.u.rational = rational(part.u, 0);
    exact.v.rational = rational(part.v, 0);
  }
}

}  // namespace

void intersect_crossing(CommonPart& out, const IntegerTriangle& triangle, const Range& range) {
  // From s = e - a: u = s . (d x E2), v = d . (s x E1), t = E2 . (s x E1), each over the determinant E1 . (d x E2).
  thread_local Vector s, s_cross_edge;
  thread_local mpz_class w;
  out.kind = TriangleKind::miss;
  const int facing = sgn(triangle.determinant);
  subtract(s, triangle.origin, triangle.a);
  dot(out.u.num, s, triangle.d_cross_edge_c);
  if (sgn(out.u.num) * facing < 0) return;
  cross(s_cross_edge, s, triangle.edge_b);
  dot(out.v.num, triangle.direction, s_cross_edge);
  if (sgn(out.v.num) * facing < 0) return;
  mpz_sub(w.get_mpz_t(), triangle.determinant.get_mpz_t(), out.u.num.get_mpz_t());
  mpz_sub(w.get_mpz_t(), w.get_mpz_t(), out.v.num.get_mpz_t());
  if (sgn(w) * facing < 0) return;
  dot(out.t.num, triangle.edge_c, s_cross_edge);
  for (Fraction* value : {&out.t, &out.u, &out.v}) {
    value->den = triangle.determinant;
    make_denominator_positive(*value);
  }
  if (!contains(range, out.t, triangle.exponent)) return;
  out.kind = feature(sgn(out.u.num), sgn(out.v.num), sgn(w));
}

bool clip(CommonPart& out, const Range& range, int exponent) {
  if (compare(out.t, exponent, range.lower) < 0) set_fraction(out.t, range.lower, exponent);
  if (range.bounded && compare(out.t_end, exponent, range.upper) > 0) set_fraction(out.t_end, range.upper, exponent);
  return compare(out.t, out.t_end) <= 0;
}

template <Real T>
TriangleHit<T> Queries::intersect(const Ray<T>& ray, const Triangle<T>& triangle, ExactTriangle* exact) {
  TriangleHit<T> hit;
  hit.status = status_of(ray, triangle);
  if (hit.status != Status::ok) {
    hit.kind = TriangleKind::invalid;
    return hit;
  }
  thread_local IntegerTriangle integers;
  thread_local CommonPart part;
  const Range range = range_of(ray);
  set_triangle(integers, ray, triangle);
  if (const int sign = sgn(integers.determinant); sign != 0) {
    hit.facing = sign > 0 ? Facing::front : Facing::back;
    intersect_crossing(part, integers, range);
  } else {
    thread_local Vector normal;
    cross(normal, integers.edge_b, integers.edge_c);
    if (is_zero(normal)) {
      intersect_degenerate(part, integers, range);
    } else {
      intersect_parallel(part, integers, normal, range);
    }
  }
  round(hit, part, integers.exponent);
  if (exact != nullptr) set_exact(*exact, part, integers.exponent);
  return hit;
}

template TriangleHit<float> Queries::intersect(const Ray<float>&, const Triangle<float>&, ExactTriangle*);
template TriangleHit<double> Queries::intersect(const Ray<double>&, const Triangle<double>&, ExactTriangle*);

}  // namespace graze::oracle::gmp
