// scene_speed [--json FILE] [--long] [growth|lattice|far|MESH|LEVELS]...: nanoseconds a ray and what a scene costs, beside
// Embree and CGAL. A number is a wavy sphere so many times refined: 20 * 4^LEVELS triangles. One thread, the same rays for all,
// every contender in every round, medians; builds on all cores. Without sections: all, and a sphere of 20,480 triangles;
// --long adds larger ones to growth.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>

#include "bench/cgal_tree.hpp"
#include "bench/scene_inputs.hpp"
#include "bench/scene_peers.hpp"
#include "bench/scene_rows.hpp"
#include "bench/timing.hpp"

namespace {

using namespace graze;
using bench::Contender, bench::SceneRow, bench::SceneRows, bench::Timing;

constexpr int rounds = 11;
/// CGAL is slow: it gets every so many-th ray.
constexpr std::size_t cgal_stride = 16;

template <Real T>
Scene<T> build(const fuzz::Mesh& mesh) {
  std::vector<Vec3<T>> points;
  points.reserve(mesh.points.size());
  for (const Vec3<double>& p : mesh.points) points.push_back({T(float(p.x)), T(float(p.y)), T(float(p.z))});
  Scene<T> scene;
  if (!scene.build({Mesh<T>{std::move(points), std::span(mesh.triangles)}}).ok()) std::exit(2);
  return scene;
}

/// The coordinates as they are.
Scene<double> build_exactly(const fuzz::Mesh& mesh) {
  Scene<double> scene;
  if (!scene.build({Mesh<double>{std::span(mesh.points), std::span(mesh.triangles)}}).ok()) std::exit(2);
  return scene;
}

template <class F>
double seconds_of(F f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Rays, class Ask>
auto each(const Rays& rays, Ask ask) {
  return [&rays, ask] {
    std::size_t hits = 0;
    for (const auto& ray : rays) hits += ask(ray) ? 1 : 0;
    return hits;
  };
}

/// A row for each contender; ratios are to that of the name `to`.
void add(SceneRows& rows, const SceneRow& about, const std::vector<Timing>& times, const std::string& to) {
  double reference = 0;
  for (const Timing& t : times) {
    if (t.name == to) reference = t.median_ns;
  }
  for (const Timing& t : times) {
    SceneRow row = about;
    row.contender = t.name;
    row.value = t.median_ns;
    row.unit = "ns a ray";
    if (reference > 0) {
      row.ratio = reference / t.median_ns;
      row.to = to;
    }
    rows.add(row);
  }
}

void race_mix(SceneRows& rows, const SceneRow& about, const Scene<float>& narrow, const Scene<double>& wide,
              const bench::EmbreeScene& robust, const bench::EmbreeScene& fast, const bench::CgalTree* cgal,
              const std::vector<Ray<float>>& rays) {
  const std::vector<Ray<double>> wide_rays = bench::converted<double>(rays);
  std::vector<Ray<double>> few;
  for (std::size_t i = 0; i < wide_rays.size(); i += cgal_stride) few.push_back(wide_rays[i]);
  const bool is_coherent = about.what == "camera";
  std::vector<RTCRayHit> space;
  std::vector<SceneHit<float>> narrow_hits(rays.size());
  std::vector<SceneHit<double>> wide_hits(rays.size());
  const auto flags = std::make_unique<bool[]>(rays.size());
  const auto told = [](const auto& hits) {
    return static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [](const auto& h) { return h.is_hit(); }));
  };
  std::vector<Contender> contenders;
  const auto contend = [&](const char* name, std::function<std::size_t()> pass) {
    contenders.push_back({name, std::move(pass), rays.size()});
  };
  if (about.what == "occlusion") {
    contend("Embree robust", each(rays, [&](const auto& r) { return robust.any(r); }));
    contend("Embree", each(rays, [&](const auto& r) { return fast.any(r); }));
    contend("graze float", each(rays, [&](const auto& r) { return narrow.any(r); }));
    contend("graze double", each(wide_rays, [&](const auto& r) { return wide.any(r); }));
    const auto met = [&flags](const auto& scene, const auto& asked) {
      scene.any(std::span(asked), std::span(flags.get(), asked.size()), {}, Threads::mine);
      return static_cast<std::size_t>(std::count(flags.get(), flags.get() + asked.size(), true));
    };
    contend("graze float batch", [&, met] { return met(narrow, rays); });
    contend("graze double batch", [&, met] { return met(wide, wide_rays); });
    if (cgal != nullptr) contenders.push_back({"CGAL EPICK", [&] { return cgal->any(few); }, few.size()});
  } else {
    contend("Embree robust", each(rays, [&](const auto& r) { return robust.closest(r) != RTC_INVALID_GEOMETRY_ID; }));
    contend("Embree", each(rays, [&](const auto& r) { return fast.closest(r) != RTC_INVALID_GEOMETRY_ID; }));
    contend("Embree packets", [&] { return fast.closest_packets(rays, is_coherent); });
    contend("Embree stream", [&] { return fast.closest_stream(rays, space, is_coherent); });
    contend("graze float", each(rays, [&](const auto& r) { return narrow.closest(r).is_hit(); }));
    contend("graze double", each(wide_rays, [&](const auto& r) { return wide.closest(r).is_hit(); }));
    contend("graze float batch", [&] {
      narrow.closest(std::span(rays), std::span(narrow_hits), {}, Threads::mine);
      return told(narrow_hits);
    });
    contend("graze double batch", [&] {
      wide.closest(std::span(wide_rays), std::span(wide_hits), {}, Threads::mine);
      return told(wide_hits);
    });
    if (cgal != nullptr) contenders.push_back({"CGAL EPICK", [&] { return cgal->closest(few); }, few.size()});
  }
  add(rows, about, bench::race(contenders, rounds), "Embree robust");
}

void measure_peers(SceneRows& rows, const fuzz::Mesh& mesh) {
  const SceneRow about{"peers", mesh.name, mesh.triangles.size(), {}, {}, 0, {}, 0, {}};
  const auto cost = [&](const char* what, const char* who, double value, const char* unit, double reference) {
    SceneRow row = about;
    row.what = what;
    row.contender = who;
    row.value = value;
    row.unit = unit;
    if (reference > 0) {
      row.ratio = reference / value;
      row.to = "Embree robust";
    }
    rows.add(row);
  };
  Scene<float> narrow;
  Scene<double> wide;
  std::unique_ptr<bench::EmbreeScene> robust;
  const double embree_s = seconds_of([&] { robust = std::make_unique<bench::EmbreeScene>(mesh, true, "threads=2"); });
  cost("build", "Embree robust", embree_s, "s", 0);
  cost("build", "graze float", seconds_of([&] { narrow = build<float>(mesh); }), "s", embree_s);
  cost("build", "graze double", seconds_of([&] { wide = build<double>(mesh); }), "s", embree_s);
  const auto a_triangle = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(mesh.triangles.size());
  };
  // Embree has copied the triangles' indices, which graze views.
  const double embree_bytes = a_triangle(robust->memory()), indices = sizeof(Corners);
  cost("memory", "Embree robust", embree_bytes, "bytes a triangle", 0);
  cost("memory", "graze float", a_triangle(narrow.memory()) + indices, "bytes a triangle", embree_bytes);
  cost("memory", "graze double", a_triangle(wide.memory()) + indices, "bytes a triangle", embree_bytes);
  const bench::EmbreeScene fast(mesh, false, "threads=2");
  constexpr std::size_t most_for_cgal = 2'000'000;
  const auto cgal = mesh.triangles.size() <= most_for_cgal ? std::make_unique<bench::CgalTree>(mesh) : nullptr;
  const Bounds<double> bounds = bench::bounds_of(mesh);
  const std::vector<Ray<float>> incoherent = bench::incoherent_rays(bounds), camera = bench::camera_rays(bounds);
  for (const char* mix : {"camera", "incoherent", "occlusion"}) {
    SceneRow row = about;
    row.what = mix;
    race_mix(rows, row, narrow, wide, *robust, fast, cgal.get(), std::string(mix) == "camera" ? camera : incoherent);
  }
}

/// Ours alone against the number of triangles.
void measure_growth(SceneRows& rows, bool is_long) {
  for (int levels = 3; levels <= (is_long ? 9 : 7); ++levels) {
    const fuzz::Mesh mesh = fuzz::wavy_sphere(levels);
    Scene<float> scene;
    const double seconds = seconds_of([&] { scene = build<float>(mesh); });
    SceneRow row{"growth", mesh.name, mesh.triangles.size(), "build", "graze float", 0, "ns a triangle", 0, {}};
    row.value = seconds * 1e9 / static_cast<double>(mesh.triangles.size());
    rows.add(row);
    const std::vector<Ray<float>> rays = bench::incoherent_rays(bench::bounds_of(mesh));
    row.what = "incoherent";
    add(rows, row,
        bench::race({{"graze float", each(rays, [&](const auto& r) { return scene.closest(r).is_hit(); }), rays.size()}},
                    rounds),
        {});
    Statistics statistics;
    for (const Ray<float>& ray : rays) static_cast<void>(scene.closest(ray, {}, statistics));
    row.what = "nodes and leaves";
    row.unit = "a ray";
    row.contender = "graze float";
    row.value = static_cast<double>(statistics.nodes + statistics.leaves) / static_cast<double>(rays.size());
    rows.add(row);
    row.what = "exact decisions";
    row.unit = "a triangle test";
    row.value = static_cast<double>(statistics.exact_decisions) / static_cast<double>(statistics.triangle_tests);
    rows.add(row);
  }
}

/// Rays along the lines of a lattice, against the same rays turned.
void measure_lattice(SceneRows& rows) {
  constexpr int side = 32;
  const fuzz::Mesh mesh = bench::cubes(side);
  const bench::LatticeRays rays = bench::lattice_rays(side);
  const Scene<double> wide = build_exactly(mesh);
  const Scene<float> narrow = build<float>(mesh);
  const auto race = [&](const auto& scene, const auto& along, const auto& turned, const char* format) {
    const auto contend = [&](const std::string& what, auto ask) {
      const SceneRow about{"lattice", mesh.name, mesh.triangles.size(), what + ", " + format, {}, 0, {}, 0, {}};
      add(rows, about,
          bench::race(
              {{"turned rays", each(turned, ask), turned.size()}, {"along the lattice", each(along, ask), along.size()}},
              rounds),
          "turned rays");
    };
    contend("closest", [&](const auto& r) { return scene.closest(r).is_hit(); });
    contend("any", [&](const auto& r) { return scene.any(r); });
  };
  race(wide, rays.along, rays.turned, "double");
  std::vector<Ray<float>> along, turned;
  const auto narrow_ray = [](const Ray<double>& r) {
    return Ray<float>{bench::narrowed(r.origin.x, r.origin.y, r.origin.z),
                      bench::narrowed(r.direction.x, r.direction.y, r.direction.z)};
  };
  for (const Ray<double>& r : rays.along) along.push_back(narrow_ray(r));
  for (const Ray<double>& r : rays.turned) turned.push_back(narrow_ray(r));
  race(narrow, along, turned, "float");
}

/// A double scene of small triangles, translated.
void measure_far(SceneRows& rows) {
  const fuzz::Mesh here = fuzz::wavy_sphere(5);
  const std::vector<Ray<double>> rays = bench::converted<double>(bench::incoherent_rays(bench::bounds_of(here)));
  struct Place {
    std::string name;
    fuzz::Mesh mesh;
    std::vector<Ray<double>> rays;
    Scene<double> scene;
  };
  std::vector<Place> places;
  for (const int exponent : {0, 22, 28, 34, 40}) {
    const double x = exponent == 0 ? 0 : std::ldexp(1.0, exponent);
    Place& place =
        places.emplace_back(exponent == 0 ? "at the origin" : "at 2^" + std::to_string(exponent), here, rays, Scene<double>());
    for (Vec3<double>& p : place.mesh.points) p = {p.x + x, p.y - x, p.z + x};
    for (Ray<double>& r : place.rays) r.origin = {r.origin.x + x, r.origin.y - x, r.origin.z + x};
    place.scene = build_exactly(place.mesh);
  }
  std::vector<Contender> contenders;
  for (const Place& place : places) {
    contenders.push_back(
        {place.name, each(place.rays, [&place](const auto& r) { return place.scene.closest(r).is_hit(); }), place.rays.size()});
  }
  const SceneRow about{"far", here.name, here.triangles.size(), "closest, double", {}, 0, {}, 0, {}};
  add(rows, about, bench::race(contenders, rounds), "at the origin");
}

fuzz::Mesh mesh_of(const std::string& name) {
  if (name.find_first_not_of("0123456789") == std::string::npos) return fuzz::wavy_sphere(std::atoi(name.c_str()));
  auto read = fuzz::read_mesh(name);
  if (const auto* error = std::get_if<fuzz::MeshError>(&read)) {
    std::fprintf(stderr, "scene_speed: %s\n", error->what.c_str());
    std::exit(2);
  }
  return std::move(std::get<fuzz::Mesh>(read));
}

}  // namespace

int main(int argc, char** argv) {
  std::string json;
  bool is_long = false;
  std::vector<std::string> sections;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--json" && i + 1 < argc) {
      json = argv[++i];
    } else if (argument == "--long") {
      is_long = true;
    } else if (argument.starts_with("-")) {
      std::fprintf(stderr, "usage: scene_speed [--json FILE] [--long] [growth|lattice|far|MESH|LEVELS]...\n");
      return 2;
    } else {
      sections.push_back(argument);
    }
  }
  if (sections.empty()) sections = {"5", "growth", "lattice", "far"};
  bench::warm_up();
  SceneRows rows;
  for (const std::string& section : sections) {
    if (section == "growth") {
      measure_growth(rows, is_long);
    } else if (section == "lattice") {
      measure_lattice(rows);
    } else if (section == "far") {
      measure_far(rows);
    } else {
      measure_peers(rows, mesh_of(section));
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("most memory this program held: %.0f MiB\n", static_cast<double>(usage.ru_maxrss) / 1024);
  if (!json.empty() && !rows.write(json)) {
    std::fprintf(stderr, "scene_speed: %s cannot be written\n", json.c_str());
    return 2;
  }
  return 0;
}
