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
  double c, discriminant, size;
};
UnitTerms unit_terms(const RaySphere<double>& query) {
  const Triple<double> e = triple<double>(query.ray.origin), center = triple<double>(query.sphere.center);
  Triple<double> d = triple<double>(query.ray.direction), l;
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), r2 = query.sphere.radius * query.sphere.radius;
  for (int k = 0; k < 3; ++k) {
    d[k] /= length;
    l[k] = e[k] - center[k];
  }
  const double b = d[0] * l[0] + (d[1] * l[1] + d[2] * l[2]);
  const double c = l[0] * l[0] + (l[1] * l[1] + (l[2] * l[2] - r2));
  return {c, b * b - c, c + 2 * r2};
}

template <class Term>
void climb_unit(std::string_view name, Term term) {
  climb<RaySphere<double>>(name, 20000, [&](const RaySphere<double>& query) {
    const Triple<mpq_class> e = triple<mpq_class>(query.ray.origin), d = triple<mpq_class>(query.ray.direction),
                            center = triple<mpq_class>(query.sphere.center);
    mpq_class a, b, c = -mpq_class(query.sphere.radius) * query.sphere.radius;
    for (int k = 0; k < 3; ++k) {
      const mpq_class l = center[k] - e[k];
      a += d[k] * d[k];
      b += d[k] * l;
      c += l * l;
    }
    if (sgn(a) == 0) return 0.0;
    return term(unit_terms(query), c, mpq_class(b * b / a - c));
  });
}

TEST_CASE("The bounds of the unit direction hold where a search makes them tight") {
  const double error = static_cast<double>(batch::unit_sphere_error) * u;
  climb_unit("unit C", [&](const UnitTerms& is, const mpq_class& c, const mpq_class&) {
    return share(is.c, c, error * mpq_class(is.size));
  });
  climb_unit("unit discriminant", [&](const UnitTerms& is, const mpq_class&, const mpq_class& discriminant) {
    return share(is.discriminant, discriminant, error * mpq_class(is.size));
  });
}

}  // namespace
}  // namespace graze::test
