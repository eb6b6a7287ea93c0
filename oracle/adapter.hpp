// One set of query functions behind the virtual interface of an oracle.
#pragma once

#include "oracle/oracle.hpp"

namespace graze::oracle {

/// The exact values behind a SphereHit; filled in as far as hit.count() goes.
struct ExactSphere {
  Exact t[2];
};

/// The exact values behind a TriangleHit; filled in as the truth documents.
struct ExactTriangle {
  Exact t, t_end, u, v;
};

/// `Queries` has a name and, for both formats, static intersect(ray, shape, pointer to exact values or null) and
/// side(point, surface).
template <class Queries>
class Adapter final : public Oracle {
 public:
  [[nodiscard]] std::string_view name() const override { return Queries::name; }

  SphereHit<float> answer(const Ray<float>& r, const Sphere<float>& s) const override {
    return Queries::intersect(r, s, nullptr);
  }
  SphereHit<double> answer(const Ray<double>& r, const Sphere<double>& s) const override {
    return Queries::intersect(r, s, nullptr);
  }
  TriangleHit<float> answer(const Ray<float>& r, const Triangle<float>& t) const override {
    return Queries::intersect(r, t, nullptr);
  }
  TriangleHit<double> answer(const Ray<double>& r, const Triangle<double>& t) const override {
    return Queries::intersect(r, t, nullptr);
  }

  SphereTruth<float> truth(const Ray<float>& r, const Sphere<float>& s) const override { return sphere_truth(r, s); }
  SphereTruth<double> truth(const Ray<double>& r, const Sphere<double>& s) const override { return sphere_truth(r, s); }
  TriangleTruth<float> truth(const Ray<float>& r, const Triangle<float>& t) const override { return triangle_truth(r, t); }
  TriangleTruth<double> truth(const Ray<double>& r, const Triangle<double>& t) const override { return triangle_truth(r, t); }

  Side side(const Vec2<float>& p, const Line<float>& s) const override { return Queries::side(p, s); }
  Side side(const Vec2<double>& p, const Line<double>& s) const override { return Queries::side(p, s); }
  Side side(const Vec3<float>& p, const Plane<float>& s) const override { return Queries::side(p, s); }
  Side side(const Vec3<double>& p, const Plane<double>& s) const override { return Queries::side(p, s); }
  Side side(const Vec3<float>& p, const Sphere<float>& s) const override { return Queries::side(p, s); }
  Side side(const Vec3<double>& p, const Sphere<double>& s) const override { return Queries::side(p, s); }

 private:
  template <Real T>
  [[nodiscard]] static SphereTruth<T> sphere_truth(const Ray<T>& ray, const Sphere<T>& sphere) {
    ExactSphere exact;
    const SphereHit<T> hit = Queries::intersect(ray, sphere, &exact);
    return {hit, {exact.t[0], exact.t[1]}};
  }

  template <Real T>
  [[nodiscard]] static TriangleTruth<T> triangle_truth(const Ray<T>& ray, const Triangle<T>& triangle) {
    ExactTriangle exact;
    const TriangleHit<T> hit = Queries::intersect(ray, triangle, &exact);
    return {hit, exact.t, exact.t_end, exact.u, exact.v};
  }
};

}  // namespace graze::oracle
