// ns a query of `hits` and `intersect` beside their peers, as ratios in one run.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bench/cgal_peers.hpp"
#include "bench/mixes.hpp"
#include "bench/timing.hpp"
#include "fuzz/subjects/moller_trumbore.hpp"
#include "graze/sphere.hpp"
#include "graze/textbook.hpp"
#include "graze/triangle.hpp"

namespace graze::bench {
namespace {

/// A pass of one query over all pairs of a mix.
template <class Mix, class Query>
Contender contender(const char* name, const Mix& mix, Query query) {
  return {name,
          [&mix, query] {
            std::size_t sum = 0;
            for (std::size_t i = 0; i < mix.rays.size(); ++i) sum += query(mix.rays[i], mix.shapes[i]);
            return sum;
          },
          mix.rays.size()};
}

template <class T>
std::size_t low_bits(T x) {
  return std::bit_cast<numeric::Bits<T>>(x) & 1;
}

void print(const char* shape, std::string_view mix, const char* precision, double share, const std::vector<Timing>& timings) {
  std::printf("\n%s, %s, %.*s: %.1f %% hit\n", shape, precision, static_cast<int>(mix.size()), mix.data(), 100 * share);
  for (const Timing& t : timings) {
    std::printf("  %-28s %9.1f ns  [%.1f, %.1f]  %8.2f x\n", t.name.c_str(), t.median_ns, t.least_ns, t.greatest_ns,
                t.median_ns / timings.front().median_ns);
  }
}

template <Real T>
constexpr const char* precision_name = sizeof(T) == sizeof(float) ? "float" : "double";

template <class Mix>
double hit_share(const Mix& mix) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < mix.rays.size(); ++i) n += hits(mix.rays[i], mix.shapes[i]);
  return static_cast<double>(n) / static_cast<double>(mix.rays.size());
}

template <Real T>
void race_triangles(const TriangleMix<T>& mix, int rounds) {
  namespace mt = fuzz::moller_trumbore;
  std::vector<Contender> contenders{
      contender("Moeller-Trumbore hits", mix, [](const auto& r, const auto& s) { return std::size_t(mt::hits(r, s)); }),
      contender("Moeller-Trumbore t u v", mix,
                [](const auto& r, const auto& s) {
                  const auto h = mt::intersect(r, s);
                  return std::size_t(h.kind) + low_bits(h.t) + low_bits(h.u) + low_bits(h.v);
                }),
      contender("Cramer hits", mix, [](const auto& r, const auto& s) { return std::size_t(textbook::cramer::hits(r, s)); }),
      contender("graze hits", mix, [](const auto& r, const auto& s) { return std::size_t(hits(r, s)); }),
      contender("graze intersect", mix, [](const auto& r, const auto& s) {
        const auto h = intersect(r, s);
        return std::size_t(h.kind) + low_bits(h.t) + low_bits(h.u) + low_bits(h.v);
      })};
  if constexpr (sizeof(T) == sizeof(double)) add_cgal_peers(contenders, mix);
  print("triangles", mix.name, precision_name<T>, hit_share(mix), race(contenders, rounds));
}

template <Real T>
void race_spheres(const SphereMix<T>& mix, int rounds) {
  std::vector<Contender> contenders{
      contender("textbook hits", mix, [](const auto& r, const auto& s) { return std::size_t(textbook::naive::hits(r, s)); }),
      contender("textbook t1 t2", mix,
                [](const auto& r, const auto& s) {
                  const auto h = textbook::naive::intersect(r, s);
                  return std::size_t(h.kind) + low_bits(h.t[0]) + low_bits(h.t[1]);
                }),
      contender("graze hits", mix, [](const auto& r, const auto& s) { return std::size_t(hits(r, s)); }),
      contender("graze intersect", mix, [](const auto& r, const auto& s) {
        const auto h = intersect(r, s);
        return std::size_t(h.kind) + low_bits(h.t[0]) + low_bits(h.t[1]);
      })};
  if constexpr (sizeof(T) == sizeof(double)) add_cgal_peers(contenders, mix);
  print("spheres", mix.name, precision_name<T>, hit_share(mix), race(contenders, rounds));
}

template <Real T>
void race_all(std::size_t n, int rounds) {
  race_triangles(random_triangles<T>(n), rounds);
  race_triangles(half_hit_triangles<T>(n), rounds);
  race_triangles(boundary_triangles<T>(n, 1 << 10), rounds);
  if (sizeof(T) == sizeof(double)) race_triangles(boundary_triangles<T>(n, 1 << 24), rounds);
  race_spheres(random_spheres<T>(n), rounds);
  race_spheres(half_hit_spheres<T>(n), rounds);
  race_spheres(tangent_spheres<T>(n, 8), rounds);
  if (sizeof(T) == sizeof(double)) race_spheres(tangent_spheres<T>(n, 2048), rounds);
}

}  // namespace
}  // namespace graze::bench

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  if (rounds < 1) {
    std::fprintf(stderr, "usage: query_speed [ROUNDS]: a positive number of interleaved rounds, 15 by default\n");
    return 2;
  }
  const std::size_t n = 65536;
  std::printf("%zu pairs a mix, medians of %d interleaved rounds, [least, greatest]; ratios to the first line of each block\n",
              n, rounds);
  graze::bench::race_all<double>(n, rounds);
  graze::bench::race_all<float>(n, rounds);
}
