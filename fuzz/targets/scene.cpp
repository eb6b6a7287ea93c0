// A small scene and a ray (fuzz/scene/scene_bytes.hpp): it is built where its primitives are valid, and refused where they are
// not; every query answers what every primitive by itself does, asked of the oracle. A disagreement is printed, and ends the
// program.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzz/scene/scene_bytes.hpp"
#include "fuzz/scene/truth.hpp"
#include "graze/numeric/bits.hpp"

namespace graze::fuzz {
namespace {

[[noreturn]] void fail(const char* precision, const std::string& what) {
  std::fprintf(stderr, "The scene is wrong, in %s: %s\n", precision, what.c_str());
  std::abort();
}

template <Real T>
bool is_valid(const SceneDraft<T>& draft) {
  for (const auto& p : draft.primitives) {
    const auto& [a, b, c] = p.triangle;
    if (!numeric::is_finite(a) || !numeric::is_finite(b) || !numeric::is_finite(c)) return false;
    if (!numeric::is_finite(p.sphere.center) || !numeric::is_finite(p.sphere.radius) || p.sphere.radius < 0) return false;
  }
  return true;
}

/// Builds the scene with every point at another place, half of them at one, and moves them where they belong.
template <Real T>
BuildStatus build_and_refit(Scene<T>& scene, const SceneQuestion<T>& question) {
  std::vector<Part<T>> parts = question.draft.parts;
  for (Part<T>& part : parts) {
    if (auto* mesh = std::get_if<Mesh<T>>(&part)) {
      std::vector<Vec3<T>> points;
      for (const Vec3<T>& p : mesh->points.get()) {
        points.push_back(points.size() % 2 == 0 ? Vec3<T>{p.y, -p.z / 2, p.x} : Vec3<T>{});
      }
      mesh->points = std::move(points);
    } else {
      auto& spheres = std::get<Spheres<T>>(part).spheres;
      std::vector<Sphere<T>> moved;
      for (const auto& [c, r] : spheres.get()) moved.push_back({{c.y, c.z, -c.x / 2}, r / 4});
      spheres = std::move(moved);
    }
  }
  BuildStatus status = scene.build(std::move(parts), {false, Threads::mine, question.is_split});
  for (std::size_t i = 0; status.ok() && i < question.draft.parts.size(); ++i) {
    const Part<T>& part = question.draft.parts[i];
    const auto* mesh = std::get_if<Mesh<T>>(&part);
    status = mesh != nullptr ? scene.refit(i, mesh->points) : scene.refit(i, std::get<Spheres<T>>(part).spheres);
  }
  return status;
}

template <Real T>
void check(const SceneQuestion<T>& question) {
  const char* const precision = sizeof(T) == 4 ? "float" : "double";
  Scene<T> scene;
  const bool is_refitted = question.is_refitted && !question.is_closed;
  const BuildStatus status = is_refitted
                                 ? build_and_refit(scene, question)
                                 : scene.build(question.draft.parts, {question.is_closed, Threads::mine, question.is_split});
  if (status.error == BuildError::open_edge && question.is_closed) return;
  if (status.ok() != is_valid(question.draft))
    fail(precision, status.ok() ? "invalid parts are taken" : "valid parts are refused");
  if (!status.ok()) return;
  if (const auto fault = find_scene_fault(scene, question.draft, question.ray, question.options)) fail(precision, *fault);
  if (!question.is_closed) return;
  const Vec3<T>& point = question.ray.origin;
  const Place place = scene.inside(point);
  if (!numeric::is_finite(point)) {
    if (place != Place::unknown) fail(precision, "a point that is not finite has a place");
    return;
  }
  Random random(1, "ways-out", 0);
  const Place truth = place_truth(question.draft, point, random);
  if (truth != Place::unknown && place != truth) fail(precision, "the ray's origin is not placed rightly");
}

}  // namespace
}  // namespace graze::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::visit([](const auto& question) { graze::fuzz::check(question); }, graze::fuzz::decode_scene({data, size}));
  return 0;
}
