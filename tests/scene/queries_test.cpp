// Queries on scenes made by hand: ties, ranges, options, invalid rays.
#include <cmath>
#include <limits>
#include <thread>

#include "fuzz/mesh/mesh.hpp"
#include "graze/scene.hpp"
#include "graze/triangle.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

/// Six triangles about the corner (0, 0, 0) of the plane z = 0.
template <Real T>
Mesh<T> fan() {
  return {std::vector<Vec3<T>>{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}},
          std::vector<Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}};
}

TEST_CASE("Of equal t the lowest index is the closest, and all of them are ties") {
  in_both_formats([]<Real T>() {
    Scene<T> scene;
    REQUIRE(scene.build({fan<T>(), Spheres<T>{std::vector<Sphere<T>>{{{0, 0, -1}, 1}, {{0, 0, -3}, 1}}}}).ok());
    const Ray<T> down{{0, 0, 1}, {0, 0, -1}};
    const SceneHit<T> closest = scene.closest(down);
    CHECK(closest.index == 0);
    CHECK(closest.triangle.kind == TriangleKind::vertex_a);
    CHECK(closest.triangle.t == 1);
    const std::vector<SceneHit<T>> ties = scene.ties(down);
    REQUIRE(ties.size() == 7);
    for (std::uint32_t i = 0; i < 7; ++i) CHECK(ties[i].index == i);
    CHECK(ties[6].sphere.t[0] == 1);
    CHECK(scene.count(down) == 8);
    const std::vector<SceneHit<T>> all = scene.all(down);
    REQUIRE(all.size() == 8);
    CHECK(all[7].index == 7);
    QueryOptions options;
    options.leave_out = 0;
    CHECK(scene.closest(down, options).index == 1);
  });
}

TEST_CASE("The range's ends belong to it") {
  in_both_formats([]<Real T>() {
    Scene<T> scene;
    REQUIRE(scene.build({fan<T>()}).ok());
    constexpr T infinity = std::numeric_limits<T>::infinity();
    const T below = std::nextafter(T(1), T(0)), above = std::nextafter(T(1), T(2));
    const auto any = [&](T t_min, T t_max) { return scene.any({{T(0.5), T(0.25), 1}, {0, 0, -1}, t_min, t_max}); };
    CHECK(any(1, 1));
    CHECK(any(1, infinity));
    CHECK(any(-5, 1));
    CHECK(!any(above, infinity));
    CHECK(!any(0, below));
    CHECK(scene.any({{T(0.5), T(0.25), 1}, {0, 0, 1}, -1, 0}));
    CHECK(!scene.any({{T(0.5), T(0.25), 1}, {0, 0, 1}}));
  });
}

TEST_CASE("Options hide what they say") {
  in_both_formats([]<Real T>() {
    Mesh<T> one = fan<T>(), two{std::vector<Vec3<T>>{{-4, -4, -1}, {4, -4, -1}, {0, 4, -1}}, std::vector<Corners>{{0, 1, 2}}};
    one.mask = 1;
    two.mask = 6;
    Scene<T> scene;
    REQUIRE(scene.build({one, two}).ok());
    const Ray<T> down{{T(0.5), T(0.25), 1}, {0, 0, -1}}, up{{T(0.5), T(0.25), -3}, {0, 0, 1}},
        along{{-3, T(0.5), 0}, {1, 0, 0}};
    const auto closest = [&](const Ray<T>& ray, const QueryOptions& options) { return scene.closest(ray, options).index; };
    CHECK(closest(down, {}) == 0);
    CHECK(closest(down, {.mask = 2}) == 6);
    CHECK(closest(down, {.mask = 1}) == 0);
    CHECK(closest(down, {.mask = 8}) == no_primitive);
    CHECK(closest(down, {.mask = 0}) == no_primitive);
    CHECK(closest(down, {.cull_back_faces = true}) == 0);
    CHECK(closest(up, {.cull_back_faces = true}) == no_primitive);
    CHECK(closest(up, {}) == 6);
    CHECK(scene.closest(along).triangle.kind == TriangleKind::coplanar);
    CHECK(closest(along, {.cull_back_faces = true}) != no_primitive);
    CHECK(closest(along, {.ignore_coplanar = true}) == no_primitive);
    CHECK(scene.count(down, {.leave_out = 6}) == 1);
  });
}

TEST_CASE("An invalid ray answers its status alone") {
  in_both_formats([]<Real T>() {
    Scene<T> scene;
    REQUIRE(scene.build({fan<T>()}).ok());
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const std::pair<Ray<T>, Status> rays[] = {{{{0, 0, 1}, {0, nan, -1}}, Status::non_finite},
                                              {{{0, 0, 1}, {0, 0, 0}}, Status::zero_direction},
                                              {{{0, 0, 1}, {0, 0, -1}, 2, 1}, Status::empty_range}};
    for (const auto& [ray, status] : rays) {
      SceneHit<T> expected;
      expected.status = status;
      CHECK(scene.closest(ray) == expected);
      CHECK(!scene.any(ray));
      CHECK(scene.count(ray) == 0);
      CHECK(scene.all(ray).empty());
      CHECK(scene.ties(ray).empty());
    }
  });
}

TEST_CASE("Two threads at once answer as one does") {
  const fuzz::Mesh mesh = fuzz::wavy_sphere(4);
  Scene<double> scene;
  REQUIRE(scene.build({Mesh<double>{mesh.points, mesh.triangles}}).ok());
  std::vector<Ray<double>> rays;
  for (const Vec3<double>& p : mesh.points) rays.push_back({{0.1, 0.2, -0.1}, {p.x - 0.1, p.y - 0.2, p.z + 0.1}});
  std::vector<SceneHit<double>> alone(rays.size()), forward(rays.size()), backward(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) alone[i] = scene.closest(rays[i]);
  std::thread up([&] {
    for (std::size_t i = 0; i < rays.size(); ++i) forward[i] = scene.closest(rays[i]);
  });
  std::thread down([&] {
    for (std::size_t i = rays.size(); i-- > 0;) backward[i] = scene.closest(rays[i]);
  });
  up.join();
  down.join();
  CHECK(alone == forward);
  CHECK(alone == backward);
}

TEST_CASE("A range may end anywhere beyond what the filter takes") {
  in_both_formats([]<Real T>() {
    const Triangle<T> triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
    Scene<T> scene;
    REQUIRE(
        scene.build({Mesh<T>{std::vector<Vec3<T>>{triangle.a, triangle.b, triangle.c}, std::vector<Corners>{{0, 1, 2}}}}).ok());
    constexpr T most = std::numeric_limits<T>::max();
    for (int e = 0; e < std::numeric_limits<T>::max_exponent; ++e) {
      const T t = std::ldexp(T(1), e);
      for (const T t_max : {std::nextafter(t, T(0)), t, std::nextafter(t, most), most}) {
        const Ray<T> ray{{T(0.25), T(0.25), 0}, {0, 0, 1 / t}, 0, t_max};
        CAPTURE(e, t_max);
        const SceneHit<T> hit = scene.closest(ray);
        CHECK(hit.is_hit() == (t_max >= t));
        CHECK(scene.any(ray) == hit.is_hit());
        CHECK(scene.count(ray) == (hit.is_hit() ? 1 : 0));
        if (hit.is_hit()) CHECK(hit.triangle == intersect(ray, triangle));
      }
    }
  });
}

}  // namespace
}  // namespace graze::test
