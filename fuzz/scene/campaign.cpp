// scene_campaign RAYS [SEED]: so many rays a precision at generated scenes, every answer of every query held against the
// oracle, and those of batches against single queries. Every other scene has spatial splits. Exit status 1 where one is wrong.
#include <cstdio>
#include <cstdlib>

#include "fuzz/scene/batches.hpp"
#include "fuzz/scene/truth.hpp"

namespace {

using namespace graze;

/// Whether all is right.
template <Real T>
bool run(std::uint64_t rays, std::uint64_t seed) {
  constexpr std::uint64_t rays_a_scene = 50;
  const fuzz::Random stream(seed, sizeof(T) == 4 ? "scene-float" : "scene-double", 0);
  std::uint64_t asked = 0, primitives = 0;
  for (std::uint64_t i = 0; asked < rays; ++i) {
    fuzz::Random random = stream.at(i);
    const fuzz::SceneDraft<T> draft = fuzz::draft_scene<T>(random);
    Scene<T> scene;
    if (!scene.build(draft.parts, {false, Threads::mine, i % 2 != 0}).ok()) {
      std::printf("scene %llu of %s is not built\n", static_cast<unsigned long long>(i), draft.family.data());
      return false;
    }
    std::vector<Ray<T>> batch;
    QueryOptions options;
    for (std::uint64_t r = 0; r < rays_a_scene; ++r, ++asked) {
      const Ray<T>& ray = batch.emplace_back(fuzz::draft_ray(draft, random));
      options = fuzz::draft_options(draft, random);
      primitives += draft.primitives.size();
      if (const auto fault = fuzz::find_scene_fault(scene, draft, ray, options)) {
        std::printf("%s, scene %llu, ray %llu of seed %llu: %s\n", draft.family.data(), static_cast<unsigned long long>(i),
                    static_cast<unsigned long long>(r), static_cast<unsigned long long>(seed), fault->c_str());
        return false;
      }
    }
    if (const auto fault = fuzz::find_batch_fault<T>(scene, batch, options)) {
      std::printf("%s, scene %llu of seed %llu: %s\n", draft.family.data(), static_cast<unsigned long long>(i),
                  static_cast<unsigned long long>(seed), fault->c_str());
      return false;
    }
  }
  std::printf("%zu bits: %llu rays, %llu primitives asked, 0 wrong (seed %llu)\n", sizeof(T) * 8,
              static_cast<unsigned long long>(asked), static_cast<unsigned long long>(primitives),
              static_cast<unsigned long long>(seed));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: scene_campaign RAYS [SEED]\n");
    return 2;
  }
  const std::uint64_t rays = std::strtoull(argv[1], nullptr, 10), seed = argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const bool is_right = run<float>(rays, seed) && run<double>(rays, seed);
  return is_right ? 0 : 1;
}
