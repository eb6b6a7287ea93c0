// ns a decision of one ray against arrays, beside the textbook's loop and what the compiler makes of branch-free formulas, and
// as shares of the machine's floor. All in one run, on one core, interleaved.
//   batch_speed [ROUNDS]
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "batch/targets.hpp"
#include "bench/batch_peers.hpp"
#include "bench/columns.hpp"
#include "bench/mixes.hpp"
#include "bench/timing.hpp"
#include "fuzz/subjects/moller_trumbore.hpp"
#include "graze/batch.hpp"
#include "graze/textbook.hpp"
#include "hwy/highway.h"

namespace graze::bench {
namespace {

constexpr std::size_t shapes_a_ray = 4096, passes = 64;

template <class Columns, class Shapes>
Columns columns_of(const Shapes& shapes) {
  Columns columns;
  for (const auto& shape : shapes) columns.add(shape);
  return columns;
}

void choose(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().DeInit();
}

template <Real T, class Arrays>
std::size_t count_hits(const std::vector<Ray<T>>& rays, const Arrays& shapes) {
  std::uint64_t mask[batch::mask_words(shapes_a_ray)];
  std::size_t n = 0;
  for (std::size_t pass = 0; pass < passes; ++pass) {
    batch::hits(rays[pass % rays.size()], shapes, mask);
    for (const std::uint64_t word : mask) n += static_cast<std::size_t>(std::popcount(word));
  }
  return n;
}

/// The textbook's scalar loop over the same arrays.
template <class Columns, Real T, class Arrays, class Hits>
Contender loop(const char* name, const std::vector<Ray<T>>& rays, const Arrays& shapes, Hits hits) {
  return {name,
          [&rays, shapes, hits] {
            std::size_t n = 0;
            for (std::size_t pass = 0; pass < passes; ++pass) {
              const Ray<T>& ray = rays[pass % rays.size()];
              for (std::size_t i = 0; i < shapes.size; ++i) n += hits(ray, Columns::at(shapes, i)) ? 1 : 0;
            }
            return n;
          },
          passes * shapes_a_ray};
}

template <Real T, class Arrays>
Contender compiled(const std::string& name, const std::vector<Ray<T>>& rays, const Arrays& shapes, Count<T, Arrays> count) {
  return {name,
          [&rays, shapes, count] {
            std::size_t n = 0;
            for (std::size_t pass = 0; pass < passes; ++pass) n += count(rays[pass % rays.size()], shapes);
            return n;
          },
          passes * shapes_a_ray};
}

template <Real T, class Arrays>
Contender batched(const std::string& name, std::int64_t target, const std::vector<Ray<T>>& rays, const Arrays& shapes) {
  return {name,
          [&rays, shapes, target] {
            choose(target);
            return count_hits(rays, shapes);
          },
          passes * shapes_a_ray};
}

/// ns a lane at best: the operations at the measured peak, or the bytes at the measured bandwidth.
template <Real T>
double floor_of(const PeerSet& peers, double operations, double bytes) {
  const auto run = sizeof(T) == sizeof(float) ? peers.float_operations : peers.double_operations;
  const std::vector<float> numbers(static_cast<std::size_t>(bytes) / sizeof(float) * shapes_a_ray);
  double operation_ns = 1e9, byte_ns = 1e9;
  volatile std::size_t sink = 0;
  for (int round = 0; round < 5; ++round) {
    double start = thread_time();
    const std::size_t done = run(1000000);
    operation_ns = std::min(operation_ns, (thread_time() - start) / static_cast<double>(done));
    start = thread_time();
    for (std::size_t pass = 0; pass < passes; ++pass) sink = sink + peers.read(numbers.data(), numbers.size());
    byte_ns = std::min(byte_ns, (thread_time() - start) / (static_cast<double>(passes * numbers.size()) * sizeof(float)));
  }
  return std::max(operations * operation_ns, bytes * byte_ns);
}

/// One instruction set: what the compiler makes for it, and the batches at it.
struct Tier {
  const char* name;
  std::vector<const PeerSet*> peers;
  std::int64_t target;
};

std::vector<Tier> tiers() {
  std::vector<Tier> all;
  choose(0);
  const std::int64_t supported = hwy::SupportedTargets();
  if ((supported & HWY_AVX2) != 0) all.push_back({"AVX2", {&peers_v3::peers}, HWY_AVX2});
  if ((supported & HWY_AVX3) != 0) all.push_back({"AVX-512", {&peers_v4::peers, &peers_v4_256::peers}, HWY_AVX3});
  return all;
}

void print(const char* what, double textbook, const Timing& t) {
  std::printf("  %-34s %8.2f ns  [%.2f, %.2f]  %7.2f x the textbook's speed%s\n", t.name.c_str(), t.median_ns, t.least_ns,
              t.greatest_ns, textbook / t.median_ns, what);
}

/// Races `contenders`, the first `loops` of them the textbook's, in groups of one tier; `operations` and `bytes` are of a lane.
template <Real T, class Arrays, class AddPeers>
void race_tiers(const char* title, const std::vector<Contender>& loops, const std::vector<Ray<T>>& rays, const Arrays& shapes,
                double operations, double bytes, int rounds, AddPeers add_peers) {
  std::printf("\n%s, %s\n", title, sizeof(T) == sizeof(float) ? "float" : "double");
  for (const Tier& tier : tiers()) {
    std::vector<Contender> contenders = loops;
    const std::size_t first_peer = contenders.size();
    for (const PeerSet* peers : tier.peers) add_peers(*peers, contenders);
    const std::size_t batch = contenders.size();
    contenders.push_back(batched(std::string("graze, ") + tier.name, tier.target, rays, shapes));
    const std::vector<Timing> timings = race(contenders, rounds);
    double textbook = timings[0].median_ns, best = 1e9;
    for (std::size_t i = 0; i < first_peer; ++i) textbook = std::min(textbook, timings[i].median_ns);
    for (std::size_t i = first_peer; i < batch; ++i) best = std::min(best, timings[i].median_ns);
    for (const Timing& t : timings) print("", textbook, t);
    if (first_peer < batch) std::printf("    %.2f x the best compiled", best / timings[batch].median_ns);
    const double floor = floor_of<T>(*tier.peers.front(), operations, bytes);
    std::printf("%s %.2f x the floor's %.2f ns\n", first_peer < batch ? "," : "   ", timings[batch].median_ns / floor, floor);
  }
}

/// One triangle in ten has an edge that the ray (0, 0, 1) from the origin passes through exactly.
template <Real T>
std::vector<Triangle<T>> doubtful(std::vector<Triangle<T>> triangles) {
  Source<T> s;
  for (std::size_t i = 0; i < triangles.size(); i += 10) {
    const T x = s.integer(500), y = s.integer(500), z = s.integer(500) + 501, w = s.integer(500);
    triangles[i] = {{x, y, z}, {-x, -y, z}, {w, s.integer(500), z + 1}};
  }
  return triangles;
}
/// One sphere in ten is touched by that ray.
template <Real T>
std::vector<Sphere<T>> doubtful(std::vector<Sphere<T>> spheres) {
  Source<T> s;
  for (std::size_t i = 0; i < spheres.size(); i += 10) {
    const T k = s.integer(99) + 100;
    spheres[i] = {{3 * k, 4 * k, s.integer(500) + 501}, 5 * k};
  }
  return spheres;
}

template <Real T>
void race_triangles(int rounds) {
  namespace mt = fuzz::moller_trumbore;
  using Columns = TriangleColumns<T>;
  using Arrays = batch::TriangleArrays<T>;
  const Triangles<T> mix = random_triangles<T>(shapes_a_ray);
  std::vector<Triangle<T>> shapes;
  for (const auto& query : mix) shapes.push_back(query.triangle);
  std::vector<Ray<T>> rays, ahead{{{0, 0, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < passes; ++i) rays.push_back(mix[i].ray);
  const auto plain = columns_of<Columns>(shapes), doubted = columns_of<Columns>(doubtful<T>(shapes));
  const auto loops = [&](const std::vector<Ray<T>>& r, const Arrays& shapes) -> std::vector<Contender> {
    return {
        loop<Columns>("Moeller-Trumbore, scalar loop", r, shapes, [](const auto& q, const auto& s) { return mt::hits(q, s); }),
        loop<Columns>("Cramer, scalar loop", r, shapes,
                      [](const auto& q, const auto& s) { return textbook::cramer::hits(q, s); })};
  };
  race_tiers<T>("one ray against 4,096 random triangles", loops(rays, plain.arrays()), rays, plain.arrays(),
                batch_triangle_operations, 9 * sizeof(T), rounds, [&](const PeerSet& peers, std::vector<Contender>& out) {
                  Count<T, Arrays> count;
                  if constexpr (sizeof(T) == sizeof(float)) {
                    count = peers.float_triangles;
                  } else {
                    count = peers.double_triangles;
                  }
                  out.push_back(compiled(std::string("Moeller-Trumbore, ") + peers.name, rays, plain.arrays(), count));
                });
  race_tiers<T>("the same, one in ten through an edge", loops(ahead, doubted.arrays()), ahead, doubted.arrays(),
                batch_triangle_operations, 9 * sizeof(T), rounds, [](const PeerSet&, std::vector<Contender>&) {});
}

template <Real T>
void race_spheres(int rounds) {
  using Columns = SphereColumns<T>;
  using Arrays = batch::SphereArrays<T>;
  const Spheres<T> mix = random_spheres<T>(shapes_a_ray);
  std::vector<Sphere<T>> shapes;
  for (const auto& query : mix) shapes.push_back(query.sphere);
  std::vector<Ray<T>> rays, ahead{{{0, 0, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < passes; ++i) rays.push_back(mix[i].ray);
  const auto plain = columns_of<Columns>(shapes), doubted = columns_of<Columns>(doubtful<T>(shapes));
  const auto loops = [&](const std::vector<Ray<T>>& r, const Arrays& shapes) -> std::vector<Contender> {
    return {loop<Columns>("textbook, scalar loop", r, shapes,
                          [](const auto& q, const auto& s) { return textbook::naive::hits(q, s); })};
  };
  race_tiers<T>("one ray against 4,096 random spheres", loops(rays, plain.arrays()), rays, plain.arrays(),
                batch_sphere_operations, 4 * sizeof(T), rounds, [&](const PeerSet& peers, std::vector<Contender>& out) {
                  Count<T, Arrays> roots, by_sign;
                  if constexpr (sizeof(T) == sizeof(float)) {
                    roots = peers.float_spheres, by_sign = peers.float_spheres_by_sign;
                  } else {
                    roots = peers.double_spheres, by_sign = peers.double_spheres_by_sign;
                  }
                  out.push_back(compiled(std::string("roots, ") + peers.name, rays, plain.arrays(), roots));
                  out.push_back(compiled(std::string("without roots, ") + peers.name, rays, plain.arrays(), by_sign));
                });
  race_tiers<T>("the same, one in ten touched", loops(ahead, doubted.arrays()), ahead, doubted.arrays(),
                batch_sphere_operations, 4 * sizeof(T), rounds, [](const PeerSet&, std::vector<Contender>&) {});
}

}  // namespace
}  // namespace graze::bench

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  if (argc > 2 || rounds < 1) {
    std::fprintf(stderr, "usage: batch_speed [ROUNDS]: a positive number of interleaved rounds, 15 by default\n");
    return 2;
  }
  std::printf("ns a decision on one core, medians of %d interleaved rounds, [least, greatest]\n", rounds);
  graze::bench::race_triangles<float>(rounds);
  graze::bench::race_triangles<double>(rounds);
  graze::bench::race_spheres<float>(rounds);
  graze::bench::race_spheres<double>(rounds);
}
