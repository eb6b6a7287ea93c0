#include "bench/floor.hpp"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "bench/batch_peers.hpp"
#include "bench/columns.hpp"
#include "bench/mixes.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace graze::bench {
namespace {

/// What a decision takes in the filter, counted in predicates/*_filter.hpp as in batch_peers.hpp.
constexpr double triangle_operations = 63, sphere_operations = 27;
/// All that fits into the second-level cache.
constexpr std::size_t resident = 2048;

struct Loop {
  const char* name;
  const char* shape;
  const char* format;
  double operations, bytes;
  Contest contest;
};

template <class Query, class Hits>
Contest single(const std::vector<Query>& queries, Hits hits) {
  return {"",
          [queries, hits] {
            std::size_t n = 0;
            for (const Query& q : queries) n += hits(q) ? 1 : 0;
            return n;
          },
          queries.size()};
}

/// One ray against all shapes.
template <class Columns, class Query, class Shape>
Contest batched(const std::vector<Query>& queries, Shape shape) {
  Columns columns;
  for (const Query& q : queries) columns.add(shape(q));
  return {"",
          [columns, ray = queries.front().ray] {
            std::uint64_t mask[batch::mask_words(resident)];
            batch::hits(ray, columns.arrays(), mask);
            return static_cast<std::size_t>(std::popcount(mask[0]));
          },
          queries.size()};
}

template <Real T>
void add_loops(const char* format, std::uint64_t seed, std::vector<Loop>& loops) {
  const Triangles<T> triangles = random_triangles<T>(resident, Source<T>(seed));
  const Spheres<T> spheres = random_spheres<T>(resident, Source<T>(seed));
  loops.push_back({"hits", "triangle", format, triangle_operations, 17 * sizeof(T),
                   single(triangles, [](const auto& q) { return hits(q.ray, q.triangle); })});
  loops.push_back({"hits", "sphere", format, sphere_operations, 12 * sizeof(T),
                   single(spheres, [](const auto& q) { return hits(q.ray, q.sphere); })});
  loops.push_back({"batch hits, one ray", "triangle", format, batch_triangle_operations, 9 * sizeof(T),
                   batched<TriangleColumns<T>>(triangles, [](const auto& q) { return q.triangle; })});
  loops.push_back({"batch hits, one ray", "sphere", format, batch_sphere_operations, 4 * sizeof(T),
                   batched<SphereColumns<T>>(spheres, [](const auto& q) { return q.sphere; })});
}

}  // namespace

nlohmann::json floor_of_loops(const Plan& plan) {
  std::fprintf(stderr, "floor\n");
  constexpr std::size_t rounds_of_operations = 20000, numbers = resident * 17 * sizeof(double) / sizeof(float);
  const std::vector<float> data(numbers);
  const PeerSet& peers = peers_v3::peers;
  std::vector<Loop> loops;
  add_loops<double>("double", plan.seed, loops);
  add_loops<float>("float", plan.seed, loops);
  const std::size_t double_operations = peers.double_operations(1) * rounds_of_operations;
  const std::size_t float_operations = peers.float_operations(1) * rounds_of_operations;
  std::vector<Contest> contests{{"double", [&] { return peers.double_operations(rounds_of_operations); }, double_operations},
                                {"float", [&] { return peers.float_operations(rounds_of_operations); }, float_operations},
                                {"read", [&] { return peers.read(data.data(), data.size()); }, numbers * sizeof(float)}};
  for (const Loop& loop : loops) contests.push_back(loop.contest);
  std::vector<std::vector<double>> rounds = measure(contests, plan.effort);
  // A peak is the best that was seen.
  const auto least = [](const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); };
  const double double_ns = least(rounds[0]), float_ns = least(rounds[1]), byte_ns = least(rounds[2]);
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Loop& l = loops[i];
    const double operation_ns = std::string_view(l.format) == "double" ? double_ns : float_ns;
    list.push_back({{"name", l.name},
                    {"shape", l.shape},
                    {"format", l.format},
                    {"operations", l.operations},
                    {"bytes", l.bytes},
                    {"floor_ns", std::max(l.operations * operation_ns, l.bytes * byte_ns)},
                    {"rounds", rounds[i + 3]}});
  }
  return {{"peaks",
           {{"vectors", peers.name},
            {"double_operations_a_ns", 1 / double_ns},
            {"float_operations_a_ns", 1 / float_ns},
            {"bytes_a_ns", 1 / byte_ns}}},
          {"loops", list}};
}

}  // namespace graze::bench
