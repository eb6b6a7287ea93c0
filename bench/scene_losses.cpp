// scene_losses MESH|LEVELS...: rays from ten points inside a closed mesh at its corners and the midpoints of its edges. Each
// must hit. How many graze loses, in float and double, and Embree, robust and default. A number is a wavy sphere so many times
// refined. Exit status 1 where graze loses one, or where a ray with nothing but faces on its way crosses an even number of
// them.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/scene_peers.hpp"
#include "fuzz/random.hpp"
#include "graze/scene.hpp"

namespace {

using namespace graze;

constexpr std::uint64_t seed = 1;
constexpr int origins = 10;

/// A mesh in T, and the rays at it from a point.
template <Real T>
struct Aims {
  std::vector<Vec3<T>> points;
  const std::vector<Corners>& triangles;

  /// Calls visit(ray) for each corner and each edge's midpoint, an edge once.
  template <class Visit>
  void each(const Vec3<T>& from, Visit visit) const {
    const auto at = [&](const Vec3<T>& p) {
      const Ray<T> ray{from, {p.x - from.x, p.y - from.y, p.z - from.z}};
      if (!(ray.direction == Vec3<T>{})) visit(ray);
    };
    for (const Vec3<T>& p : points) at(p);
    for (const Corners& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t i = t[k], j = t[(k + 1) % 3];
        if (i > j) continue;
        const Vec3<T>&p = points[i], &q = points[j];
        at({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      }
    }
  }
};

struct Losses {
  std::uint64_t rays = 0, lost = 0, robust_lost = 0, default_lost = 0, all_faces = 0, even = 0;
};

/// In float the same rays are given to Embree.
template <Real T>
bool measure(const fuzz::Mesh& mesh) {
  std::vector<Vec3<T>> points;
  for (const Vec3<double>& p : mesh.points) points.push_back({T(p.x), T(p.y), T(p.z)});
  const Aims<T> aims{points, mesh.triangles};
  Scene<T> scene;
  const BuildStatus status = scene.build({Mesh<T>{points, mesh.triangles}}, {true, Threads::all});
  if (!status.ok()) {
    std::fprintf(stderr, "scene_losses: %s is not closed (triangle %u, edge %u)\n", mesh.name.c_str(), status.element,
                 status.corner);
    std::exit(2);
  }
  constexpr bool is_float = sizeof(T) == 4;
  const bench::EmbreeScene robust(mesh, true), fast(mesh, false);
  const Bounds<T> b = scene.bounds();
  const fuzz::Random stream(seed, "origins", 0);
  Losses sum;
  int found = 0;
  for (std::uint64_t i = 0; found < origins && i < 100000; ++i) {
    fuzz::Random random = stream.at(i);
    const auto between = [&](T low, T high) {
      return static_cast<T>(low + (high - low) * static_cast<T>(static_cast<double>(random.bits() >> 11) * 0x1p-53));
    };
    Vec3<T> from;
    from.x = between(b.low.x, b.high.x);
    from.y = between(b.low.y, b.high.y);
    from.z = between(b.low.z, b.high.z);
    if (scene.inside(from) != Place::inside) continue;
    ++found;
    aims.each(from, [&](const Ray<T>& ray) {
      ++sum.rays;
      sum.lost += !scene.any(ray);
      if (sum.rays % 16 == 0) {
        const std::vector<SceneHit<T>> hits = scene.all(ray);
        const bool is_plain =
            std::all_of(hits.begin(), hits.end(), [](const auto& h) { return h.triangle.kind == TriangleKind::face; });
        sum.all_faces += is_plain;
        sum.even += is_plain && hits.size() % 2 == 0;
      }
      if constexpr (is_float) {
        sum.robust_lost += !robust.any(ray);
        sum.default_lost += !fast.any(ray);
      }
    });
  }
  std::printf("%-28s %-6s %11llu %9llu", mesh.name.c_str(), is_float ? "float" : "double",
              static_cast<unsigned long long>(sum.rays), static_cast<unsigned long long>(sum.lost));
  if (is_float) {
    std::printf(" %14llu %15llu", static_cast<unsigned long long>(sum.robust_lost),
                static_cast<unsigned long long>(sum.default_lost));
  } else {
    std::printf(" %14s %15s", "-", "-");
  }
  std::printf(" %11llu %5llu\n", static_cast<unsigned long long>(sum.all_faces), static_cast<unsigned long long>(sum.even));
  return sum.lost == 0 && sum.even == 0 && found == origins;
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("%-28s %-6s %11s %9s %14s %15s %11s %5s\n", "mesh", "", "rays", "lost", "Embree robust", "Embree default",
              "faces alone", "even");
  bool is_right = true;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const bool is_level = name.find_first_not_of("0123456789") == std::string::npos;
    auto read =
        is_level ? std::variant<fuzz::Mesh, fuzz::MeshError>(fuzz::wavy_sphere(std::atoi(argv[i]))) : fuzz::read_mesh(name);
    if (const auto* error = std::get_if<fuzz::MeshError>(&read)) {
      std::fprintf(stderr, "scene_losses: %s\n", error->what.c_str());
      return 2;
    }
    const auto& mesh = std::get<fuzz::Mesh>(read);
    is_right = measure<float>(mesh) && is_right;
    is_right = measure<double>(mesh) && is_right;
  }
  return is_right ? 0 : 1;
}
