// scene_speed MESH|LEVELS...: nanoseconds a ray beside Embree and as ratios to it. A number is a wavy sphere so many times
// refined. One thread, the same rays for all, every contender in every round, medians.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/scene_peers.hpp"
#include "bench/timing.hpp"
#include "fuzz/random.hpp"
#include "graze/scene.hpp"

namespace {

using namespace graze;

constexpr std::uint64_t seed = 1;
constexpr std::size_t side = 128, rays_a_mix = side * side;

double choose_unit(fuzz::Random& random) {
  return static_cast<double>(random.bits() >> 11) * 0x1p-53;
}

Bounds<double> bounds_of(const fuzz::Mesh& mesh) {
  Bounds<double> b{mesh.points[0], mesh.points[0]};
  for (const Vec3<double>& p : mesh.points) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
  }
  return b;
}

/// In single precision, so that a double scene gets the same rays.
std::vector<Ray<float>> camera_rays(const Bounds<double>& b) {
  const double size = std::max({b.high.x - b.low.x, b.high.y - b.low.y, b.high.z - b.low.z});
  const Vec3<double> eye{(b.low.x + b.high.x) / 2 + 0.3 * size, (b.low.y + b.high.y) / 2 + 0.2 * size, b.high.z + 1.5 * size};
  std::vector<Ray<float>> rays;
  for (std::size_t i = 0; i < rays_a_mix; ++i) {
    const double x = b.low.x + (b.high.x - b.low.x) * static_cast<double>(i % side) / side;
    const double y = b.low.y + (b.high.y - b.low.y) * static_cast<double>(i / side) / side;
    rays.push_back({{float(eye.x), float(eye.y), float(eye.z)},
                    {float(x - eye.x), float(y - eye.y), float((b.low.z + b.high.z) / 2 - eye.z)}});
  }
  return rays;
}

/// From any point of the bounds to any other.
std::vector<Ray<float>> incoherent_rays(const Bounds<double>& b) {
  const fuzz::Random stream(seed, "incoherent", 0);
  std::vector<Ray<float>> rays;
  for (std::size_t i = 0; i < rays_a_mix; ++i) {
    fuzz::Random random = stream.at(i);
    const auto point = [&] {
      Vec3<double> p;
      p.x = b.low.x + (b.high.x - b.low.x) * choose_unit(random);
      p.y = b.low.y + (b.high.y - b.low.y) * choose_unit(random);
      p.z = b.low.z + (b.high.z - b.low.z) * choose_unit(random);
      return p;
    };
    const Vec3<double> from = point(), to = point();
    rays.push_back(
        {{float(from.x), float(from.y), float(from.z)}, {float(to.x - from.x), float(to.y - from.y), float(to.z - from.z)}});
  }
  return rays;
}

template <Real T>
std::vector<Ray<T>> converted(const std::vector<Ray<float>>& rays) {
  std::vector<Ray<T>> out;
  for (const auto& [e, d, t_min, t_max] : rays)
    out.push_back({{T(e.x), T(e.y), T(e.z)}, {T(d.x), T(d.y), T(d.z)}, T(t_min), T(t_max)});
  return out;
}

template <Real T>
Scene<T> build(const fuzz::Mesh& mesh) {
  std::vector<Vec3<T>> points;
  for (const Vec3<double>& p : mesh.points) points.push_back({T(float(p.x)), T(float(p.y)), T(float(p.z))});
  Scene<T> scene;
  if (!scene.build({Mesh<T>{std::move(points), mesh.triangles}}).ok()) std::exit(2);
  return scene;
}

void race(const char* mix, const Scene<float>& narrow, const Scene<double>& wide, const bench::EmbreeScene& robust,
          const bench::EmbreeScene& fast, const std::vector<Ray<float>>& rays, bool is_occlusion, int rounds) {
  const std::vector<Ray<double>> wide_rays = converted<double>(rays);
  const bool is_coherent = std::string(mix) == "camera";
  std::vector<RTCRayHit> space;
  const auto each = [](const auto& all, auto ask) {
    return [&all, ask] {
      std::size_t hits = 0;
      for (const auto& ray : all) hits += ask(ray) ? 1 : 0;
      return hits;
    };
  };
  std::vector<bench::Contender> contenders;
  const auto add = [&](const char* name, std::function<std::size_t()> pass) {
    contenders.push_back({name, std::move(pass), rays.size()});
  };
  if (is_occlusion) {
    add("Embree robust", each(rays, [&](const auto& r) { return robust.any(r); }));
    add("Embree", each(rays, [&](const auto& r) { return fast.any(r); }));
    add("graze float", each(rays, [&](const auto& r) { return narrow.any(r); }));
    add("graze double", each(wide_rays, [&](const auto& r) { return wide.any(r); }));
  } else {
    add("Embree robust", each(rays, [&](const auto& r) { return robust.closest(r) != RTC_INVALID_GEOMETRY_ID; }));
    add("Embree", each(rays, [&](const auto& r) { return fast.closest(r) != RTC_INVALID_GEOMETRY_ID; }));
    add("Embree packets", [&] { return fast.closest_packets(rays, is_coherent); });
    add("Embree stream", [&] { return fast.closest_stream(rays, space, is_coherent); });
    add("graze float", each(rays, [&](const auto& r) { return narrow.closest(r).is_hit(); }));
    add("graze double", each(wide_rays, [&](const auto& r) { return wide.closest(r).is_hit(); }));
  }
  const std::vector<bench::Timing> times = bench::race(contenders, rounds);
  std::printf("  %-11s", mix);
  for (const bench::Timing& t : times)
    std::printf("  %s %.0f ns (%.2f)", t.name.c_str(), t.median_ns, times[0].median_ns / t.median_ns);
  std::printf("\n");
}

void measure(const std::string& name) {
  const bool is_level = name.find_first_not_of("0123456789") == std::string::npos;
  fuzz::Mesh mesh;
  if (is_level) {
    mesh = fuzz::wavy_sphere(std::atoi(name.c_str()));
  } else {
    auto read = fuzz::read_mesh(name);
    if (const auto* error = std::get_if<fuzz::MeshError>(&read)) {
      std::fprintf(stderr, "scene_speed: %s\n", error->what.c_str());
      std::exit(2);
    }
    mesh = std::move(std::get<fuzz::Mesh>(read));
  }
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto seconds = [](auto a, auto b) { return std::chrono::duration<double>(b - a).count(); };
  const auto t0 = now();
  const Scene<float> narrow = build<float>(mesh);
  const auto t1 = now();
  const bench::EmbreeScene robust(mesh, true, "threads=2");
  const auto t2 = now();
  const bench::EmbreeScene fast(mesh, false, "threads=2");
  const Scene<double> wide = build<double>(mesh);
  std::printf("%s: %zu triangles; built in %.3f s, Embree robust in %.3f s; %.1f bytes a triangle, double %.1f\n",
              mesh.name.c_str(), mesh.triangles.size(), seconds(t0, t1), seconds(t1, t2),
              double(narrow.memory()) / double(narrow.size()), double(wide.memory()) / double(wide.size()));
  const Bounds<double> bounds = bounds_of(mesh);
  const std::vector<Ray<float>> incoherent = incoherent_rays(bounds);
  constexpr int rounds = 11;
  race("camera", narrow, wide, robust, fast, camera_rays(bounds), false, rounds);
  race("incoherent", narrow, wide, robust, fast, incoherent, false, rounds);
  race("occlusion", narrow, wide, robust, fast, incoherent, true, rounds);
}

}  // namespace

int main(int argc, char** argv) {
  std::printf("ns a ray, in brackets how many times as fast as Embree's single robust rays; %zu rays a mix\n", rays_a_mix);
  if (argc == 1) measure("5");
  for (int i = 1; i < argc; ++i) measure(argv[i]);
}
