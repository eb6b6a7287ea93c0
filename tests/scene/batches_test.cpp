// Batches against single queries, bit for bit.
#include "fuzz/scene/batches.hpp"

#include <limits>

#include "fuzz/scene/draft.hpp"
#include "scene/kernels.hpp"
#include "tests/catch.hpp"
#include "tests/scene/each_scene.hpp"
#include "tests/scene/each_target.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::Random, fuzz::SceneDraft;

constexpr std::uint64_t seed = 1;

/// A ray at what is hard in the scene; one in four with a number that batches have no short way for, which may be invalid.
template <Real T>
Ray<T> batch_ray(const SceneDraft<T>& draft, Random& random) {
  using Limits = std::numeric_limits<T>;
  Ray<T> ray = fuzz::draft_ray(draft, random);
  if (!random.one_in(4)) return ray;
  T* const numbers[] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z, &ray.direction.x,
                        &ray.direction.y, &ray.direction.z, &ray.t_min,    &ray.t_max};
  constexpr T values[] = {0,
                          T(-0.0),
                          1,
                          -1,
                          Limits::min(),
                          Limits::denorm_min(),
                          -Limits::max(),
                          Limits::infinity(),
                          Limits::quiet_NaN(),
                          Limits::min() * 3};
  for (int n = random.between(1, 3); n > 0; --n) *numbers[random.below(8)] = values[random.below(10)];
  return ray;
}

template <Real T>
std::vector<Ray<T>> batch_rays(const SceneDraft<T>& draft, std::size_t size, Random& random) {
  std::vector<Ray<T>> rays;
  while (rays.size() < size) rays.push_back(batch_ray(draft, random));
  return rays;
}

/// Every other scene has spatial splits.
template <Real T, class Visit>
void each_batch_scene(std::uint64_t scenes, Visit visit, const EachTarget* targets = nullptr) {
  each_scene<T>(
      "batches", scenes,
      [&](std::uint64_t i) {
        if (targets != nullptr) targets->choose(i / 2);
        return BuildOptions{false, Threads::mine, i % 2 != 0};
      },
      visit);
}

TEST_CASE("Batches of every length answer as single queries do, from every target") {
  const EachTarget targets;
  in_both_formats([&]<Real T>() {
    each_batch_scene<T>(
        303,
        [&, i = std::size_t(0)](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) mutable {
          const std::vector<Ray<T>> rays = batch_rays(draft, i++ % 101, random);
          const auto fault = fuzz::find_batch_fault<T>(scene, rays, fuzz::draft_options(draft, random));
          if (!fault) return;
          INFO(*fault);
          REQUIRE(!fault.has_value());
        },
        &targets);
  });
}

TEST_CASE("A batch on all threads answers as single queries do") {
  in_both_formats([]<Real T>() {
    each_batch_scene<T>(4, [](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) {
      const std::vector<Ray<T>> rays = batch_rays(draft, 5000, random);
      CHECK(fuzz::find_batch_fault<T>(scene, rays, {}, Threads::all).value_or("") == "");
    });
  });
}

TEST_CASE("A batch at a scene of nothing misses") {
  in_both_formats([]<Real T>() {
    const Scene<T> scene;
    std::vector<Ray<T>> rays(20, {{0, 0, 0}, {1, 0, 0}});
    rays[3].direction = {};
    CHECK(fuzz::find_batch_fault<T>(scene, rays, {}).value_or("") == "");
  });
}

template <Real T>
std::vector<SceneHit<T>> closest_of(const Scene<T>& scene, const std::vector<Ray<T>>& rays) {
  std::vector<SceneHit<T>> hits(rays.size());
  scene.closest(std::span(rays), std::span(hits), {}, Threads::mine);
  return hits;
}

TEST_CASE("Batches answer the same in every environment") {
  in_both_formats([]<Real T>() {
    each_batch_scene<T>(40, [](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) {
      const std::vector<Ray<T>> rays = batch_rays(draft, 40, random);
      std::vector<SceneHit<T>> expected;
      for (const Ray<T>& ray : rays) expected.push_back(scene.closest(ray));
      for (const Environment& environment : environments) {
        CAPTURE(environment);
        const std::vector<SceneHit<T>> hits = in_mode(environment, closest_of<T>, scene, rays);
        REQUIRE(std::ranges::equal(hits, expected, [](const auto& a, const auto& b) { return fuzz::same_bits(a, b); }));
      }
    });
  });
}

/// A stack of triangles: a ray through it has seven more to visit at every level.
TEST_CASE("A ray of a batch with more to visit than its agenda holds answers as it does alone") {
  const EachTarget targets;
  constexpr std::uint32_t triangles = 200'000;
  std::vector<Vec3<float>> points;
  std::vector<Corners> corners;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const auto z = static_cast<float>(i);
    points.insert(points.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
    corners.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::vector<Ray<float>> rays;
  for (int i = 0; i < 10; ++i) {
    const float x = 0.03125F * static_cast<float>(i);
    rays.push_back({{x, 0, i % 2 == 0 ? -1.0F : 2 * triangles}, {0, x / triangles, i % 2 == 0 ? 1.0F : -1.0F}});
  }
  for (std::size_t t = 0; t < targets.size(); ++t) {
    targets.choose(t);
    Scene<float> scene;
    REQUIRE(scene.build({Mesh<float>{std::span<const Vec3<float>>(points), std::span<const Corners>(corners)}}).ok());
    CHECK(scene.count(rays[0]) == triangles);
    CHECK(fuzz::find_batch_fault<float>(scene, rays, {}).value_or("") == "");
  }
}

}  // namespace
}  // namespace graze::test
