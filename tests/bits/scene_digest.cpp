// A digest of what scenes answer, by one ray and by spans of them, in all floating-point modes; by every instruction set of the
// processor, or, compiled for one alone, by that.
//   scene_digest           prints it: a line for each precision, with a hash of shapes and rays and one of the answers
//   scene_digest GOLDEN    compares it with that file
// Exit status: 0 all is the same, 1 not, 2 the file cannot be read.
#include <fstream>
#include <memory>
#include <vector>

#include "fuzz/random.hpp"
#include "graze/scene.hpp"
#include "tests/bits/digest.hpp"
#include "tests/bits/targets.hpp"

namespace graze::fuzz {
namespace {

constexpr int side = 40, rays_of_a_scene = 4000, spheres_of_a_scene = 60;

template <Real T>
Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Hills over a square, spheres among them, and rays at corners, along edges and anywhere. Made by sums alone, so that no
/// compiler can round them otherwise.
template <Real T>
struct World {
  std::vector<Vec3<T>> points;
  std::vector<Corners> triangles;
  std::vector<Sphere<T>> spheres;
  std::vector<Ray<T>> rays;

  World() {
    Random random(digest_seed, "scene", sizeof(T));
    const auto number = [&random](int least, int most) {
      return static_cast<T>(random.between(least * 256, most * 256)) / 256;
    };
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const T x = static_cast<T>(column) + number(0, 1), y = static_cast<T>(row) + number(0, 1);
        points.push_back({x, y, number(0, 3)});
      }
    }
    for (std::uint32_t i = 0; i < side * (side - 1); ++i) {
      if (i % side == side - 1) continue;
      triangles.push_back({i, i + 1, i + side});
      triangles.push_back({i + 1, i + side + 1, i + side});
    }
    const auto point = [&] { return Vec3<T>{number(0, side), number(0, side), number(-2, 5)}; };
    for (int i = 0; i < spheres_of_a_scene; ++i) spheres.push_back({point(), number(0, 2)});
    const auto corner = [&] { return points[random.below(points.size())]; };
    for (int i = 0; i < rays_of_a_scene; ++i) {
      const Vec3<T> from = random.one_in(4) ? corner() : point(), to = random.one_in(3) ? point() : corner();
      Ray<T> ray{from, difference(to, from)};
      if (random.one_in(4)) ray.t_max = number(0, 2);
      rays.push_back(ray);
    }
  }
};

template <Real T>
void add(const Vec3<T>& v, Hash& hash) {
  hash.add(v.x), hash.add(v.y), hash.add(v.z);
}
template <Real T>
void add(const SceneHit<T>& hit, Hash& hash) {
  hash.add(hit.status), hash.add(hit.shape), hash.add(std::uint64_t{hit.index}), hash.add(hit.triangle), hash.add(hit.sphere);
}

template <Real T>
Digest digest_of() {
  const World<T> world;
  Hash inputs;
  for (const Vec3<T>& p : world.points) add(p, inputs);
  for (const Sphere<T>& s : world.spheres) add(s.center, inputs), inputs.add(s.radius);
  for (const Ray<T>& r : world.rays) add(r.origin, inputs), add(r.direction, inputs), inputs.add(r.t_max);
  std::array<Hash, float_modes.size()> answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const FloatModeScope scope(float_modes[i]);
    Scene<T> scene;
    answers[i].add(std::uint64_t{scene.build({Mesh<T>{world.points, world.triangles}, Spheres<T>{world.spheres}}).ok()});
    std::vector<SceneHit<T>> hits(world.rays.size());
    const auto met = std::make_unique<bool[]>(world.rays.size());
    scene.closest(std::span(world.rays), std::span(hits));
    scene.any(std::span(world.rays), std::span(met.get(), world.rays.size()));
    for (std::size_t ray = 0; ray < world.rays.size(); ++ray) {
      add(hits[ray], answers[i]);
      add(scene.closest(world.rays[ray]), answers[i]);
      answers[i].add(std::uint64_t{met[ray]});
      answers[i].add(scene.count(world.rays[ray]));
    }
  }
  Digest digest{inputs.text(), answers[0].text()};
  for (std::size_t i = 1; i < answers.size(); ++i) {
    if (answers[i].text() != answers[0].text()) digest.unlike_modes.append("; ").append(name_of(float_modes[i]));
  }
  return digest;
}

Digests digests() {
  return {{"scene float", digest_of<float>()}, {"scene double", digest_of<double>()}};
}

}  // namespace
}  // namespace graze::fuzz

int main(int argc, char** argv) {
  using namespace graze::fuzz;
  if (argc > 2) {
    std::cerr << "usage: scene_digest [GOLDEN]\n";
    return 2;
  }
  if (argc == 1) {
    const Digests ours = digests();
    print(ours, "shapes and rays", "scene_digest");
    return are_modes_alike(ours) ? 0 : 1;
  }
  std::ifstream file(argv[1]);
  if (!file) {
    std::cerr << argv[1] << ": cannot be read\n";
    return 2;
  }
  const Digests golden = read(file);
  const bool is_same = with_each_target([&](const char* target) {
    const bool is_well_here = is_well(golden, digests());
    std::cerr << "scenes, " << target << (is_well_here ? ": as they should be\n" : ": not so\n");
    return is_well_here;
  });
  return is_same ? 0 : 1;
}
