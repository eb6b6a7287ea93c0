// What a scene does not need is not done: seen in the counters.
#include <cmath>
#include <limits>

#include "fuzz/mesh/mesh.hpp"
#include "fuzz/random.hpp"
#include "graze/scene.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using fuzz::Random;

template <Real T>
Scene<T> sphere_of_triangles(int levels, bool has_sphere = false) {
  const fuzz::Mesh mesh = fuzz::icosphere(levels);
  std::vector<Vec3<T>> points;
  for (const Vec3<double>& p : mesh.points) points.push_back({T(p.x), T(p.y), T(p.z)});
  std::vector<Part<T>> parts{Mesh<T>{points, mesh.triangles}};
  if (has_sphere) parts.push_back(Spheres<T>{std::vector<Sphere<T>>{{{0, 0, 0}, T(0.5)}}});
  Scene<T> scene;
  const bool is_built = scene.build(std::move(parts)).ok();
  REQUIRE(is_built);
  return scene;
}

/// From about the sphere of radius 3 to about the origin.
template <Real T>
Ray<T> choose_ray(Random& random) {
  const auto number = [&] { return static_cast<T>(random.between(-1'000'000, 1'000'000)) * T(1e-6); };
  Ray<T> ray;
  ray.origin.x = 3 * number();
  ray.origin.y = 3 * number();
  ray.origin.z = 3;
  ray.direction.x = number() - ray.origin.x;
  ray.direction.y = number() - ray.origin.y;
  ray.direction.z = number() - 3;
  return ray;
}

TEST_CASE("`any` and `count` round nothing, `closest` one hit, `all` each") {
  in_both_formats([]<Real T>() {
    const Scene<T> scene = sphere_of_triangles<T>(4, true);
    const Random stream(1, "statistics", sizeof(T));
    int hits = 0;
    for (std::uint64_t i = 0; i < 500; ++i) {
      Random random = stream.at(i);
      const Ray<T> ray = choose_ray<T>(random);
      Statistics any, count, closest, all;
      const bool is_hit = scene.any(ray, {}, any);
      const std::uint64_t n = scene.count(ray, {}, count);
      CHECK(scene.closest(ray, {}, closest) == scene.closest(ray));
      CHECK(scene.all(ray, {}, all).size() == n);
      hits += is_hit;
      CHECK(is_hit == (n > 0));
      CHECK(any.roundings == 0);
      CHECK(count.roundings == 0);
      CHECK(closest.roundings == (is_hit ? 1 : 0));
      CHECK(all.roundings == n);
      CHECK(any.exact_orders == 0);
      CHECK(count.exact_orders == 0);
      CHECK(any.triangle_tests <= count.triangle_tests);
      CHECK(closest.triangle_tests <= count.triangle_tests);
      const auto settled = [](const Statistics& s) { return s.filter_misses + s.filter_hits + s.exact_decisions; };
      for (const Statistics& s : {count, closest, all}) CHECK(settled(s) == s.triangle_tests + s.sphere_tests);
      // The first hit ends it.
      CHECK(settled(any) <= any.triangle_tests + any.sphere_tests);
    }
    CHECK(hits > 200);
  });
}

TEST_CASE("A scene without spheres makes no sphere test") {
  const Scene<double> scene = sphere_of_triangles<double>(3);
  const Random stream(1, "no-spheres", 0);
  Statistics statistics;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random = stream.at(i);
    static_cast<void>(scene.closest(choose_ray<double>(random), {}, statistics));
  }
  CHECK(statistics.sphere_tests == 0);
  CHECK(statistics.triangle_tests > 200);
}

TEST_CASE("A scene of small integers runs no error bound, and rays of other numbers do") {
  in_both_formats([]<Real T>() {
    // A block of 3 x 3 x 3 cubes' worth of surface, and a square inside it.
    std::vector<Vec3<T>> points;
    std::vector<Corners> triangles;
    const auto square = [&](const Vec3<T>& p, const Vec3<T>& q, const Vec3<T>& r, const Vec3<T>& s) {
      const auto first = static_cast<std::uint32_t>(points.size());
      points.insert(points.end(), {p, q, r, s});
      triangles.insert(triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    };
    for (int k = 0; k < 4; ++k) {
      const T z = T(k);
      square({0, 0, z}, {3, 0, z}, {3, 3, z}, {0, 3, z});
      square({0, z, 0}, {0, z, 3}, {3, z, 3}, {3, z, 0});
    }
    Scene<T> scene;
    REQUIRE(scene.build({Mesh<T>{points, triangles}}).ok());
    const Random stream(1, "small-integers", sizeof(T));
    Statistics integers, others;
    std::uint64_t hits = 0;
    for (std::uint64_t i = 0; i < 500; ++i) {
      Random random = stream.at(i);
      Ray<T> ray;
      for (T* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z}) *x = static_cast<T>(random.between(-5, 8));
      for (T* x : {&ray.direction.x, &ray.direction.y, &ray.direction.z}) *x = static_cast<T>(random.between(-2, 2));
      if (ray.direction == Vec3<T>{}) continue;
      hits += scene.closest(ray, {}, integers).is_hit();
      static_cast<void>(scene.any(ray, {}, integers));
      static_cast<void>(scene.count(ray, {}, integers));
      static_cast<void>(scene.all(ray, {}, integers));
      ray.direction.x += T(0.1);
      static_cast<void>(scene.closest(ray, {}, others));
    }
    CHECK(hits > 30);
    CHECK(integers.error_bounds == 0);
    CHECK(integers.filter_hits > hits);
    CHECK(integers.exact_orders < integers.filter_hits);
    CHECK(others.error_bounds == others.triangle_tests);
  });
}

TEST_CASE("The greatest number for the range's end costs little more than none") {
  in_both_formats([]<Real T>() {
    const Scene<T> scene = sphere_of_triangles<T>(4);
    const Random stream(1, "greatest-end", sizeof(T));
    Statistics endless, ended;
    for (std::uint64_t i = 0; i < 500; ++i) {
      Random random = stream.at(i);
      Ray<T> ray = choose_ray<T>(random);
      const SceneHit<T> hit = scene.closest(ray, {}, endless);
      ray.t_max = std::numeric_limits<T>::max();
      CHECK(scene.closest(ray, {}, ended) == hit);
    }
    CHECK(ended.triangle_tests == endless.triangle_tests);
    CHECK(ended.filter_hits + ended.exact_decisions == endless.filter_hits + endless.exact_decisions);
    CHECK(ended.exact_decisions * 1000 <= ended.triangle_tests);
  });
}

TEST_CASE("Nodes visited grow with the logarithm of the number of triangles, and doubt is rare") {
  in_both_formats([]<Real T>() {
    double nodes[5];
    for (int levels = 2; levels < 7; ++levels) {
      const Scene<T> scene = sphere_of_triangles<T>(levels);
      const Random stream(1, "nodes", 0);
      Statistics statistics;
      constexpr int rays = 500;
      for (std::uint64_t i = 0; i < rays; ++i) {
        Random random = stream.at(i);
        static_cast<void>(scene.closest(choose_ray<T>(random), {}, statistics));
      }
      nodes[levels - 2] = static_cast<double>(statistics.nodes) / rays;
      CHECK(statistics.exact_decisions * 1000 <= statistics.triangle_tests);
    }
    CAPTURE(nodes[0], nodes[1], nodes[2], nodes[3], nodes[4]);
    // Four times the triangles, two thirds of a level more.
    for (int i = 1; i < 5; ++i) CHECK(nodes[i] - nodes[i - 1] < 4);
  });
}

TEST_CASE("Behind a hit a scene of floats is searched hardly further than one of doubles, however small its triangles are") {
  const Scene<float> narrow = sphere_of_triangles<float>(7);
  const Scene<double> wide = sphere_of_triangles<double>(7);
  const Random stream(1, "behind", 0);
  Statistics floats, doubles;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Random random = stream.at(i);
    const Ray<float> ray = choose_ray<float>(random);
    const auto& [e, d, t_min, t_max] = ray;
    static_cast<void>(narrow.closest(ray, {}, floats));
    static_cast<void>(wide.closest({{e.x, e.y, e.z}, {d.x, d.y, d.z}}, {}, doubles));
  }
  CAPTURE(floats.nodes, doubles.nodes, floats.leaves, doubles.leaves);
  CHECK(static_cast<double>(floats.nodes) < 1.02 * static_cast<double>(doubles.nodes));
  CHECK(static_cast<double>(floats.leaves) < 1.05 * static_cast<double>(doubles.leaves));
}

TEST_CASE("A scene far from the origin is not searched from end to end") {
  const fuzz::Mesh mesh = fuzz::icosphere(5);
  Statistics here, far;
  for (Statistics* statistics : {&here, &far}) {
    const double distance = statistics == &far ? 0x1p30 : 0;
    std::vector<Vec3<double>> points = mesh.points;
    for (Vec3<double>& p : points) p = {p.x + distance, p.y + distance, p.z - distance};
    Scene<double> scene;
    REQUIRE(scene.build({Mesh<double>{points, mesh.triangles}}).ok());
    const Random stream(1, "far", 0);
    for (std::uint64_t i = 0; i < 500; ++i) {
      Random random = stream.at(i);
      Ray<double> ray = choose_ray<double>(random);
      ray.origin = {ray.origin.x + distance, ray.origin.y + distance, ray.origin.z - distance};
      static_cast<void>(scene.closest(ray, {}, *statistics));
    }
  }
  CHECK(static_cast<double>(far.nodes) < 1.1 * static_cast<double>(here.nodes));
  CHECK(static_cast<double>(far.triangle_tests) < 1.1 * static_cast<double>(here.triangle_tests));
}

}  // namespace
}  // namespace graze::test
