// A scene refitted to moved shapes answers like one built of them.
#include <cmath>
#include <limits>

#include "fuzz/scene/truth.hpp"
#include "graze/triangle.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using fuzz::Random;

TEST_CASE("A refitted scene answers for the shapes as they are now") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 5;
    const Random stream(seed, "refit", sizeof(T));
    int refitted = 0;
    for (std::uint64_t i = 0; i < 120; ++i) {
      INFO("seed " << seed << ", scene " << i);
      Random random = stream.at(i);
      fuzz::SceneDraft<T> draft = fuzz::draft_scene<T>(random);
      Scene<T> scene;
      REQUIRE(scene.build(draft.parts).ok());
      // All points swapped about, and then doubled in places.
      std::size_t first = 0;
      for (std::size_t p = 0; p < draft.parts.size(); ++p) {
        if (auto* mesh = std::get_if<Mesh<T>>(&draft.parts[p])) {
          const std::span<const Vec3<T>> old = mesh->points.get();
          std::vector<Vec3<T>> points(old.rbegin(), old.rend());
          for (Vec3<T>& v : points) v = {v.y, v.z / 2, -v.x};
          mesh->points = points;
          REQUIRE(scene.refit(p, mesh->points).ok());
          for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
            const Corners& c = mesh->triangles[t];
            draft.primitives[first++].triangle = {points[c[0]], points[c[1]], points[c[2]]};
          }
        } else {
          auto& part = std::get<Spheres<T>>(draft.parts[p]);
          std::vector<Sphere<T>> spheres(part.spheres.get().begin(), part.spheres.get().end());
          for (Sphere<T>& s : spheres) s = {{s.center.z, -s.center.x / 2, s.center.y}, s.radius / 2};
          part.spheres = spheres;
          REQUIRE(scene.refit(p, part.spheres).ok());
          for (const Sphere<T>& s : spheres) draft.primitives[first++].sphere = s;
        }
        ++refitted;
      }
      for (int r = 0; r < 10; ++r) {
        const auto fault = fuzz::find_scene_fault(scene, draft, fuzz::draft_ray(draft, random), {});
        if (!fault) continue;
        INFO("ray " << r << ": " << *fault);
        REQUIRE(!fault.has_value());
      }
    }
    CHECK(refitted > 100);
  });
}

TEST_CASE("Viewed points that moved in place are seen after refit") {
  std::vector<Vec3<double>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Corners> triangle{{0, 1, 2}};
  Scene<double> scene;
  REQUIRE(scene.build({Mesh<double>{std::span<const Vec3<double>>(points), triangle}}).ok());
  for (Vec3<double>& p : points) p.z = 1e6;
  REQUIRE(scene.refit().ok());
  CHECK(scene.closest({{0.25, 0.25, 0}, {0, 0, 1}}).triangle.t == 1e6);
  CHECK(scene.bounds() == Bounds<double>{{0, 0, 1e6}, {1, 1, 1e6}});
  points[1].x = std::nan("");
  CHECK(scene.refit() == BuildStatus{BuildError::non_finite, 0, 0, 1});
  CHECK(scene.closest({{0.25, 0.25, 0}, {0, 0, 1}}).triangle.t == 1e6);
}

TEST_CASE("Points that were one may come apart by a refit, and be one again") {
  in_both_formats([]<Real T>() {
    // A fan about the z axis, each triangle with points of its own, and then each at a height of its own.
    constexpr int n = 64;
    const auto fan = [](bool is_apart) {
      std::vector<Vec3<T>> points;
      const auto corner = [&](int i, T r, T z) {
        const T angle = T(i % n) * T(2 * 3.14159265358979 / n);
        points.push_back({r * std::cos(angle), r * std::sin(angle), z});
      };
      for (int i = 0; i < n; ++i) {
        const T z = is_apart ? T(i) / 8 : T(0);
        corner(i, 0, z + 1);
        corner(i, 1, z);
        corner(i + 1, 1, z);
      }
      return points;
    };
    std::vector<Corners> triangles;
    for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    Scene<T> scene;
    REQUIRE(scene.build({Mesh<T>{fan(false), triangles}}).ok());
    for (const bool is_apart : {true, false, true}) {
      REQUIRE(scene.refit(0, fan(is_apart)).ok());
      const std::vector<Vec3<T>> points = fan(is_apart);
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto& [a, b, c] = triangles[i];
        const Triangle<T> triangle{points[a], points[b], points[c]};
        const Ray<T> ray{{(triangle.b.x + triangle.c.x) / 3, (triangle.b.y + triangle.c.y) / 3, T(100)}, {0, 0, -1}};
        const SceneHit<T> hit = scene.closest(ray);
        REQUIRE(hit.is_hit());
        CHECK(hit.index == i);
        CHECK(hit.triangle == intersect(ray, triangle));
        CHECK(scene.count(ray) == 1);
      }
    }
  });
}

TEST_CASE("Another number of points or spheres is refused, and the scene stays") {
  Scene<float> scene;
  REQUIRE(scene
              .build({Mesh<float>{std::vector<Vec3<float>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, std::vector<Corners>{{0, 1, 2}}},
                      Spheres<float>{std::vector<Sphere<float>>{{{5, 0, 0}, 1}}}})
              .ok());
  CHECK(scene.refit(0, std::vector<Vec3<float>>(4)).error == BuildError::other_topology);
  CHECK(scene.refit(1, std::vector<Vec3<float>>(3)).error == BuildError::other_topology);
  CHECK(scene.refit(2, std::vector<Vec3<float>>(3)).error == BuildError::other_topology);
  CHECK(scene.refit(1, std::vector<Sphere<float>>(2)).error == BuildError::other_topology);
  CHECK(scene.refit(0, std::vector<Sphere<float>>(1)).error == BuildError::other_topology);
  CHECK(scene.refit(1, std::vector<Sphere<float>>{{{5, 0, 0}, -1}}) == BuildStatus{BuildError::negative_radius, 1, 0, 0});
  CHECK(scene.any({{0.25F, 0.25F, 1}, {0, 0, -1}}));
  CHECK(scene.any({{5, 0, 4}, {0, 0, -1}}));
}

TEST_CASE("A closed scene that comes apart is not refitted") {
  const std::vector<Vec3<double>> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
  Scene<double> scene;
  REQUIRE(
      scene
          .build({Mesh<double>{points, std::vector<Corners>{{0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {0, 3, 2}}}}, {true, Threads::all})
          .ok());
  CHECK(scene.inside({0.1, 0.1, 0.1}) == Place::inside);
  std::vector<Vec3<double>> apart = points;
  apart[4].z = 2;
  CHECK(scene.refit(0, apart).error == BuildError::open_edge);
  CHECK(scene.bounds().high.z == 1);
  CHECK(scene.inside({0.1, 0.1, 0.1}) == Place::inside);
  apart[3].z = 2;
  CHECK(scene.refit(0, apart).ok());
  CHECK(scene.inside({0.1, 0.1, 1.5}) == Place::inside);
}

}  // namespace
}  // namespace graze::test
