// The textbook's formulas in any number type N: 80-bit, double-word, rational. The input is taken as it is, the answer rounded
// to double at the end. N has +, -, *, /, comparisons, N(double), square_root(n) and to_double(n).
// What the wider type cannot mend: a discriminant or determinant that cancels below its unit, so tangents and edges are still
// decided by noise, only rarer; rationals decide exactly, take roots to 256 bits, and cut the last digit off.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <string_view>

#include "bench/double_word.hpp"
#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"

namespace graze::bench {

inline long double square_root(long double a) {
  return std::sqrt(a);
}
inline double to_double(long double a) {
  return static_cast<double>(a);
}
inline mpq_class square_root(const mpq_class& a) {
  return mpq_class(sqrt(mpf_class(a, 256)));
}
inline double to_double(const mpq_class& a) {
  return a.get_d();
}

namespace wide {

template <class N>
struct Vec {
  N x, y, z;
};

template <class N>
Vec<N> vec(const Vec3<double>& v) {
  return {N(v.x), N(v.y), N(v.z)};
}
template <class N>
Vec<N> minus(const Vec<N>& a, const Vec<N>& b) {
  return {N(a.x - b.x), N(a.y - b.y), N(a.z - b.z)};
}
template <class N>
N dot(const Vec<N>& a, const Vec<N>& b) {
  return N(a.x * b.x + a.y * b.y + a.z * b.z);
}
template <class N>
Vec<N> cross(const Vec<N>& a, const Vec<N>& b) {
  return {N(a.y * b.z - a.z * b.y), N(a.z * b.x - a.x * b.z), N(a.x * b.y - a.y * b.x)};
}
template <class N>
bool in_range(const Ray<double>& ray, const N& t) {
  return t >= N(ray.t_min) && (std::isinf(ray.t_max) || t <= N(ray.t_max));
}

/// The quadratic without cancellation, sgn(0) = 1.
template <class N>
SphereHit<double> intersect(const Ray<double>& ray, const Sphere<double>& sphere) {
  const Vec<N> d = vec<N>(ray.direction), l = minus(vec<N>(sphere.center), vec<N>(ray.origin));
  const N r(sphere.radius), zero(0.0);
  const N a = dot(d, d), b = dot(d, l), c = N(dot(l, l) - r * r), discriminant = N(b * b - a * c);
  SphereHit<double> hit;
  hit.origin = c < zero ? OriginSide::inside : c > zero ? OriginSide::outside : OriginSide::on;
  if (!(discriminant >= zero)) return hit;
  if (discriminant == zero) {
    const N t = N(b / a);
    if (!in_range(ray, t)) return hit;
    hit.kind = SphereKind::tangent;
    hit.root = Root::both;
    hit.t[0] = to_double(t);
    return hit;
  }
  const N root = square_root(discriminant), q = b < zero ? N(b - root) : N(b + root);
  const N s = N(q / a), t = N(c / q);
  const N &first = s < t ? s : t, &second = s < t ? t : s;
  const bool has_first = in_range(ray, first), has_second = in_range(ray, second);
  if (!has_first && !has_second) return hit;
  hit.kind = SphereKind::secant;
  hit.root = has_first && has_second ? Root::both : has_first ? Root::first : Root::second;
  hit.t[0] = to_double(has_first ? first : second);
  if (has_first && has_second) hit.t[1] = to_double(second);
  return hit;
}

template <class N>
TriangleKind kind_at(const N& u, const N& v, const N& w) {
  const N zero(0.0);
  if (!(u >= zero && v >= zero && w >= zero)) return TriangleKind::miss;
  if (u == zero) return v == zero ? TriangleKind::vertex_a : w == zero ? TriangleKind::vertex_c : TriangleKind::edge_ca;
  if (v == zero) return w == zero ? TriangleKind::vertex_b : TriangleKind::edge_ab;
  return w == zero ? TriangleKind::edge_bc : TriangleKind::face;
}

/// Cramer's rule.
template <class N>
TriangleHit<double> intersect(const Ray<double>& ray, const Triangle<double>& triangle) {
  const Vec<N> d = vec<N>(ray.direction), a = vec<N>(triangle.a);
  const Vec<N> e1 = minus(vec<N>(triangle.b), a), e2 = minus(vec<N>(triangle.c), a), s = minus(vec<N>(ray.origin), a);
  const Vec<N> p = cross(d, e2);
  const N determinant = dot(e1, p), zero(0.0);
  TriangleHit<double> hit;
  hit.facing = determinant > zero ? Facing::front : determinant < zero ? Facing::back : Facing::none;
  if (determinant == zero) return hit;
  const Vec<N> q = cross(s, e1);
  const N u = N(dot(s, p) / determinant), v = N(dot(d, q) / determinant), t = N(dot(e2, q) / determinant);
  if (!in_range(ray, t)) return hit;
  hit.kind = kind_at(u, v, N(N(1.0) - u - v));
  if (hit.kind == TriangleKind::miss) return hit;
  hit.t = hit.t_end = to_double(t);
  hit.u = to_double(u);
  hit.v = to_double(v);
  return hit;
}

/// Of every formula that divides by the determinant.
inline constexpr fuzz::Deviations triangle_deviations{
    {fuzz::Deviation::coplanar_is_miss, fuzz::Deviation::degenerate_is_miss, fuzz::Deviation::invalid_unhandled}};

/// As the formulas of fuzz/subjects are.
template <class N>
struct Formula {
  static constexpr fuzz::Deviations deviations = triangle_deviations;
  static SphereHit<double> answer(const fuzz::RaySphere<double>& q) { return intersect<N>(q.ray, q.sphere); }
  static TriangleHit<double> answer(const fuzz::RayTriangle<double>& q) { return intersect<N>(q.ray, q.triangle); }
};

}  // namespace wide

}  // namespace graze::bench
