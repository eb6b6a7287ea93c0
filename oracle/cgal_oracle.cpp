// The CGAL oracle behind the common interface: the one file that compiles CGAL.
#include "oracle/adapter.hpp"
#include "oracle/cgal_sphere.hpp"
#include "oracle/cgal_triangle.hpp"

namespace graze::oracle {
namespace cgal {

[[nodiscard]] Side side_of_sign(CGAL::Sign sign) {
  return {Status::ok, static_cast<Sign>(static_cast<int>(sign))};
}

struct Queries {
  static constexpr std::string_view name = "cgal";

  template <Real T>
  [[nodiscard]] static SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere, ExactSphere* exact) {
    return intersect_sphere(ray, sphere, exact);
  }
  template <Real T>
  [[nodiscard]] static TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle, ExactTriangle* exact) {
    return intersect_triangle(ray, triangle, exact);
  }

  template <Real T>
  [[nodiscard]] static Side side(const Vec2<T>& p, const graze::Line<T>& line) {
    if (!all_finite(p.x, p.y, line.a, line.b, line.c)) return {Status::non_finite, Sign::zero};
    if (line.a == 0 && line.b == 0) return side_of_sign(CGAL::sign(Number(line.c)));
    const Kernel::Line_2 zero_set(Number(line.a), Number(line.b), Number(line.c));
    return side_of_sign(zero_set.oriented_side(Kernel::Point_2(Number(p.x), Number(p.y))));
  }
  template <Real T>
  [[nodiscard]] static Side side(const Vec3<T>& p, const Plane<T>& plane) {
    if (!all_finite(p) || !all_finite(plane.a, plane.b, plane.c, plane.d)) return {Status::non_finite, Sign::zero};
    if (plane.a == 0 && plane.b == 0 && plane.c == 0) return side_of_sign(CGAL::sign(Number(plane.d)));
    const Kernel::Plane_3 zero_set(Number(plane.a), Number(plane.b), Number(plane.c), Number(plane.d));
    return side_of_sign(zero_set.oriented_side(point(p)));
  }
  template <Real T>
  [[nodiscard]] static Side side(const Vec3<T>& p, const Sphere<T>& sphere) {
    if (!all_finite(p) || !all_finite(sphere.center) || !all_finite(sphere.radius)) return {Status::non_finite, Sign::zero};
    if (sphere.radius < 0) return {Status::negative_radius, Sign::zero};
    const CGAL::Bounded_side where = cgal_sphere(sphere).bounded_side(point(p));
    return {Status::ok,
            where == CGAL::ON_BOUNDED_SIDE ? Sign::negative : (where == CGAL::ON_BOUNDARY ? Sign::zero : Sign::positive)};
  }
};

}  // namespace cgal

const Oracle& cgal_oracle() {
  static const Adapter<cgal::Queries> oracle;
  return oracle;
}

}  // namespace graze::oracle
