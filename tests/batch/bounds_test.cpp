// The lanes' own forms are within their bounds where a search makes those tight. Other tests see verdicts alone; this one
// computes the terms as the lanes without fused operations do, in double, against rationals. The forms of pairs are those of
// tests/predicates.
#include "batch/bounds.hpp"

#include <gmpxx.h>

#include <array>

#include "tests/predicates/hill_climb.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RaySphere, fuzz::RayTriangle;

constexpr double u = batch::Bounds<double>::unit;

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Triple<Number> triple(const Vec3<double>& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

/// As sheared_triangles-inl.hpp, along z.
template <class Number>
struct Sheared {
  Number u, v, w, t, q, z;
};
template <class Number>
Sheared<Number> sheared(const RayTriangle<double>& query) {
  const Triple<Number> e = triple<Number>(query.ray.origin), d = triple<Number>(query.ray.direction);
  const Number sx = d[0] / d[2], sy = d[1] / d[2];
  const auto corner = [&](const Vec3<double>& p) {
    const Triple<Number> c = triple<Number>(p);
    const Number x = e[0] - c[0], y = e[1] - c[1], z = e[2] - c[2];
    return Triple<Number>{Number(x - sx * z), Number(y - sy * z), z};
  };
  const Triple<Number> a = corner(query.triangle.a), b = corner(query.triangle.b), c = corner(query.triangle.c);
  Sheared<Number> out;
  out.u = c[0] * b[1] - c[1] * b[0];
  out.v = a[0] * c[1] - a[1] * c[0];
  out.w = b[0] * a[1] - b[1] * a[0];
  out.t = -(out.u * a[2]) - (out.v * b[2] + out.w * c[2]);
  out.z = a[2] * a[2] + (b[2] * b[2] + c[2] * c[2]);
  const Number xx = a[0] * a[0] + (b[0] * b[0] + c[0] * c[0]), yy = a[1] * a[1] + (b[1] * b[1] + c[1] * c[1]);
  out.q = xx + yy + out.z;
  return out;
}

double share(double computed, const mpq_class& exact, const mpq_class& bound) {
  if (sgn(bound) == 0) return 0;
  return mpq_class(abs(computed - exact) / bound).get_d();
}

/// The greatest share of the term over the rounding modes; 0 where z is not the longest axis.
template <class Term>
void climb_sheared(std::string_view name, Term term) {
  climb<RayTriangle<double>>(name, 20000, [&](const RayTriangle<double>& query) {
    const Vec3<double>& d = query.ray.direction;
    if (d.z == 0 || std::fabs(d.z) < std::max(std::fabs(d.x), std::fabs(d.y))) return 0.0;
    const Sheared<mpq_class> exact = sheared<mpq_class>(query);
    double greatest = 0;
    for (const FloatMode mode : rounding_modes) {
      greatest = std::max(greatest, term(in_mode({mode, false}, sheared<double>, query), exact));
    }
    return greatest;
  });
}

TEST_CASE("The bounds of the sheared ray hold where a search makes them tight") {
  const double error = static_cast<double>(batch::sheared_error) * u;
  using Computed = Sheared<double>;
  using Exact = Sheared<mpq_class>;
  climb_sheared("sheared weight",
                [&](const Computed& is, const Exact& exact) { return share(is.u, exact.u, error * mpq_class(is.q)); });
  // The code squares both sides.
  climb_sheared("sheared distance", [&](const Computed& is, const Exact& exact) {
    return share(is.t, exact.t, error * mpq_class(is.q) * std::sqrt(is.z));
  });
}

/// As unit_spheres-inl.hpp.
struct UnitTerms {
  double b, c, discriminant, q;
};
UnitTerms unit_terms(const RaySphere<double>& query) {
  const Triple<double> e = triple<double>(query.ray.origin), center = triple<double>(query.sphere.center);
  Triple<double> d = triple<double>(query.ray.direction), l;
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), r2 = query.sphere.radius * query.sphere.radius;
  for (int k = 0; k < 3; ++k) {
    d[k] /= length;
    l[k] = e[k] - center[k];
  }
  const double b = d[0] * l[0] + (d[1] * l[1] + d[2] * l[2]), q = l[0] * l[0] + (l[1] * l[1] + l[2] * l[2]), c = q - r2;
  return {b, c, b * b - c, q};
}

/// The same without error: B and D times A and its square root.
struct ExactTerms {
  mpq_class a, b, c, q;
};
ExactTerms exact_terms(const RaySphere<double>& query) {
  const Triple<mpq_class> e = triple<mpq_class>(query.ray.origin), d = triple<mpq_class>(query.ray.direction),
                          center = triple<mpq_class>(query.sphere.center);
  ExactTerms out;
  for (int k = 0; k < 3; ++k) {
    const mpq_class l = e[k] - center[k];
    out.a += d[k] * d[k];
    out.b += d[k] * l;
    out.q += l * l;
  }
  out.c = out.q - mpq_class(query.sphere.radius) * query.sphere.radius;
  return out;
}

template <class Term>
void climb_unit(std::string_view name, Term term) {
  climb<RaySphere<double>>(name, 20000, [&](const RaySphere<double>& query) {
    const ExactTerms exact = exact_terms(query);
    return sgn(exact.a) == 0 ? 0.0 : term(unit_terms(query), exact);
  });
}

TEST_CASE("The bounds of the unit direction hold where a search makes them tight") {
  const double error = static_cast<double>(batch::unit_sphere_error) * u;
  // Where the origin is outside; elsewhere only the signs are claimed.
  climb_unit("unit C", [&](const UnitTerms& is, const ExactTerms& exact) {
    return sgn(exact.c) < 0 ? 0.0 : share(is.c, exact.c, error * mpq_class(is.q));
  });
  climb_unit("unit discriminant", [&](const UnitTerms& is, const ExactTerms& exact) {
    const mpq_class discriminant = exact.b * exact.b / exact.a - exact.c;
    return sgn(exact.c) < 0 ? 0.0 : share(is.discriminant, discriminant, error * mpq_class(is.q));
  });
}

TEST_CASE("Beyond the bound of the unit direction the signs are right, inside and outside") {
  const double error = static_cast<double>(batch::unit_sphere_error) * u;
  // How near to the bound a wrong sign comes: the lesser of D and C as a share of it, where either's sign is wrong.
  climb_unit("unit signs", [&](const UnitTerms& is, const ExactTerms& exact) {
    const int c = sgn(exact.c), discriminant = sgn(mpq_class(exact.b * exact.b - exact.a * exact.c)), b = sgn(exact.b);
    const bool is_hit = discriminant >= 0 && (c <= 0 || b <= 0), seems_hit = is.discriminant >= 0 && (is.c <= 0 || is.b <= 0);
    const double least = std::fabs(std::min(is.discriminant, is.c));
    return is_hit == seems_hit || is.q == 0 ? 0.0 : least / (error * is.q);
  });
}

}  // namespace
}  // namespace graze::test
