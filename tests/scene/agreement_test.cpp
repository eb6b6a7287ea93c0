// Scenes held against every primitive asked of the oracle.
#include "fuzz/same_bits.hpp"
#include "fuzz/scene/truth.hpp"
#include "tests/catch.hpp"
#include "tests/scene/each_scene.hpp"
#include "tests/scene/each_target.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::Random, fuzz::SceneDraft;

template <Real T, class Visit>
void each_plain_scene(std::uint64_t scenes, Visit visit) {
  each_scene<T>(
      "scene-test", scenes, [](std::uint64_t) { return BuildOptions{}; }, visit);
}

TEST_CASE("A scene answers what every primitive by itself answers") {
  in_both_formats([]<Real T>() {
    each_plain_scene<T>(400, [](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) {
      for (int r = 0; r < 20; ++r) {
        const Ray<T> ray = fuzz::draft_ray(draft, random);
        const auto fault = fuzz::find_scene_fault(scene, draft, ray, fuzz::draft_options(draft, random));
        if (!fault) continue;
        INFO("ray " << r << ": " << *fault);
        REQUIRE(!fault.has_value());
      }
    });
  });
}

template <Real T>
struct Answers {
  SceneHit<T> closest;
  std::vector<SceneHit<T>> all, ties;
  bool any = false;
  std::uint64_t count = 0;
  bool operator==(const Answers&) const = default;
};

template <Real T>
Answers<T> ask(const Scene<T>& scene, const Ray<T>& ray) {
  return {scene.closest(ray), scene.all(ray), scene.ties(ray), scene.any(ray), scene.count(ray)};
}

template <Real T>
BuildStatus build(Scene<T>& scene, const std::vector<Part<T>>& parts) {
  return scene.build(parts, {false, Threads::mine});
}

TEST_CASE("Every environment gives the same answers, whichever the scene was built in") {
  in_both_formats([]<Real T>() {
    each_plain_scene<T>(60, [](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) {
      std::vector<Ray<T>> rays;
      for (int r = 0; r < 12; ++r) rays.push_back(fuzz::draft_ray(draft, random));
      for (const Environment& environment : environments) {
        Scene<T> other;
        REQUIRE(in_mode(environment, build<T>, other, draft.parts).ok());
        for (const Ray<T>& ray : rays) {
          const Answers<T> plain = ask(scene, ray);
          const bool is_same = plain == in_mode(environment, ask<T>, scene, ray) && plain == ask(other, ray);
          if (is_same) continue;
          CAPTURE(environment);
          REQUIRE(is_same);
        }
      }
    });
  });
}

TEST_CASE("Every target gives the same answers") {
  const EachTarget targets;
  CHECK(targets.size() > 1);
  in_both_formats([&]<Real T>() {
    each_plain_scene<T>(60, [&](const SceneDraft<T>& draft, const Scene<T>&, Random& random) {
      std::vector<Scene<T>> scenes(targets.size());
      for (std::size_t t = 0; t < targets.size(); ++t) {
        targets.choose(t);
        REQUIRE(build(scenes[t], draft.parts).ok());
      }
      for (int r = 0; r < 20; ++r) {
        const Ray<T> ray = fuzz::draft_ray(draft, random);
        const Answers<T> first = ask(scenes[0], ray);
        for (std::size_t t = 1; t < targets.size(); ++t) {
          const bool is_same = ask(scenes[t], ray) == first;
          if (is_same) continue;
          CAPTURE(r, t);
          REQUIRE(is_same);
        }
      }
    });
  });
}

TEST_CASE("A ray that begins or ends at the end of the numbers' range is answered by every target") {
  const EachTarget targets;
  in_both_formats([&]<Real T>() {
    constexpr T most = std::numeric_limits<T>::max();
    for (std::uint64_t i = 0; i < targets.size(); ++i) {
      targets.choose(i);
      Scene<T> scene;
      REQUIRE(
          scene.build({Mesh<T>{std::vector<Vec3<T>>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, std::vector<Corners>{{0, 1, 2}}}}).ok());
      for (const T length : {T(1), T(1024), T(0x1p-30), T(0x1p-100)}) {
        Ray<T> ray{{T(0.25), T(0.25), 0}, {0, 0, length}};
        const auto is_hit = [&](T t_min, T t_max) {
          ray.t_min = t_min;
          ray.t_max = t_max;
          const bool is_one = scene.any(ray);
          return is_one == scene.closest(ray).is_hit() && is_one == (scene.count(ray) == 1) ? int(is_one) : -1;
        };
        constexpr T endless = std::numeric_limits<T>::infinity();
        CHECK(is_hit(most, endless) == 0);
        CHECK(is_hit(most, most) == 0);
        CHECK(is_hit(-most, endless) == 1);
        CHECK(is_hit(-most, most) == 1);
        CHECK(is_hit(-most, -most) == 0);
      }
    }
  });
}

TEST_CASE("Spans of rays are answered like single rays, on one thread or all") {
  in_both_formats([]<Real T>() {
    each_plain_scene<T>(10, [](const SceneDraft<T>& draft, const Scene<T>& scene, Random& random) {
      std::vector<Ray<T>> rays;
      for (int r = 0; r < 200; ++r) rays.push_back(fuzz::draft_ray(draft, random));
      rays[7].direction = {};
      for (const Threads threads : {Threads::mine, Threads::all}) {
        std::vector<SceneHit<T>> closest(rays.size());
        std::vector<std::vector<SceneHit<T>>> all(rays.size());
        std::vector<std::uint64_t> count(rays.size());
        const auto any = std::make_unique<bool[]>(rays.size());
        const std::span<const Ray<T>> asked(rays);
        scene.closest(asked, closest, {}, threads);
        scene.all(asked, std::span(all), {}, threads);
        scene.count(asked, count, {}, threads);
        scene.any(asked, std::span(any.get(), rays.size()), {}, threads);
        int different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
          different += !(closest[i] == scene.closest(rays[i])) || all[i] != scene.all(rays[i]) ||
                       count[i] != scene.count(rays[i]) || any[i] != scene.any(rays[i]);
        }
        CHECK(different == 0);
        CHECK(closest[7].status == Status::zero_direction);
      }
    });
  });
}

}  // namespace
}  // namespace graze::test
