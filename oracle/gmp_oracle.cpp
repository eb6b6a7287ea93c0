// The GMP oracle behind the common interface.
#include "oracle/gmp_queries.hpp"

namespace graze::oracle {
namespace {

class GmpOracle final : public Oracle {
 public:
  [[nodiscard]] std::string_view name() const override { return "gmp"; }

  SphereHit<float> answer(const Ray<float>& r, const Sphere<float>& s) const override { return gmp::intersect(r, s, nullptr); }
  SphereHit<double> answer(const Ray<double>& r, const Sphere<double>& s) const override { return gmp::intersect(r, s, nullptr); }
  TriangleHit<float> answer(const Ray<float>& r, const Triangle<float>& t) const override { return gmp::intersect(r, t, nullptr); }
  TriangleHit<double> answer(const Ray<double>& r, const Triangle<double>& t) const override {
    return gmp::intersect(r, t, nullptr);
  }

  SphereTruth<float> truth(const Ray<float>& r, const Sphere<float>& s) const override { return sphere_truth(r, s); }
  SphereTruth<double> truth(const Ray<double>& r, const Sphere<double>& s) const override { return sphere_truth(r, s); }
  TriangleTruth<float> truth(const Ray<float>& r, const Triangle<float>& t) const override { return triangle_truth(r, t); }
  TriangleTruth<double> truth(const Ray<double>& r, const Triangle<double>& t) const override { return triangle_truth(r, t); }

  Side side(const Vec2<float>& p, const Line<float>& l) const override { return gmp::side(p, l); }
  Side side(const Vec2<double>& p, const Line<double>& l) const override { return gmp::side(p, l); }
  Side side(const Vec3<float>& p, const Plane<float>& s) const override { return gmp::side(p, s); }
  Side side(const Vec3<double>& p, const Plane<double>& s) const override { return gmp::side(p, s); }
  Side side(const Vec3<float>& p, const Sphere<float>& s) const override { return gmp::side(p, s); }
  Side side(const Vec3<double>& p, const Sphere<double>& s) const override { return gmp::side(p, s); }

 private:
  template <Real T>
  [[nodiscard]] static SphereTruth<T> sphere_truth(const Ray<T>& ray, const Sphere<T>& sphere) {
    gmp::ExactSphere exact;
    const SphereHit<T> hit = gmp::intersect(ray, sphere, &exact);
    return {hit, {exact.t[0], exact.t[1]}};
  }

  template <Real T>
  [[nodiscard]] static TriangleTruth<T> triangle_truth(const Ray<T>& ray, const Triangle<T>& triangle) {
    gmp::ExactTriangle exact;
    const TriangleHit<T> hit = gmp::intersect(ray, triangle, &exact);
    return {hit, exact.t, exact.t_end, exact.u, exact.v};
  }
};

}  // namespace

const Oracle& gmp_oracle() {
  static const GmpOracle oracle;
  return oracle;
}

}  // namespace graze::oracle
