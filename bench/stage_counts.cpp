// stage_counts [QUERIES [SEED]]: how often the kernel's stages ran on inputs of which a share is degenerate, as JSON. The
// kernel keeps no counters: its sources are compiled for this program with a call of ours at the beginning of every function
// (-finstrument-functions), inlined ones included, and the functions that are stages are told by their names.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>

#include "bench/certainty_mix.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"

namespace {

/// By address.
std::unordered_map<void*, std::size_t>& calls() {
  static std::unordered_map<void*, std::size_t> all;
  return all;
}
bool is_counting = false;

}  // namespace

extern "C" {
__attribute__((no_instrument_function)) void __cyg_profile_func_enter(void* function, void*) {
  if (!is_counting) return;
  is_counting = false;
  ++calls()[function];
  is_counting = true;
}
__attribute__((no_instrument_function)) void __cyg_profile_func_exit(void*, void*) {}
}

namespace {

using namespace graze;

/// Calls of functions whose mangled name begins so; lambdas inside them begin otherwise.
std::size_t calls_of(std::string_view beginning, std::string_view part = "") {
  std::size_t n = 0;
  for (const auto& [function, count] : calls()) {
    Dl_info info;
    if (dladdr(function, &info) == 0 || info.dli_sname == nullptr) continue;
    const std::string_view name = info.dli_sname;
    n += name.starts_with(beginning) && name.find(part) != std::string_view::npos ? count : 0;
  }
  return n;
}

template <class Ask, class Query>
nlohmann::json count(const std::vector<Query>& queries, Ask ask) {
  calls().clear();
  std::size_t sum = 0;
  is_counting = true;
  for (const Query& query : queries) sum += ask(query);
  is_counting = false;
  return {{"queries", queries.size()},
          {"hits", sum},
          {"refined", calls_of("_ZN5graze10predicates19refine_discriminant")},
          {"rounding", calls_of("_ZN5graze8rounding5rootsIdEE") + calls_of("_ZN5graze8rounding4faceIdEE")},
          {"exact", calls_of("_ZN5graze5exact9intersectIdEE") + calls_of("_ZN5graze5exact4hitsIdEE")},
          {"rounded_exactly", calls_of("_ZN5graze7numeric13round_to_bits")},
          {"midpoint", calls_of("_ZNK5graze5exact", "12compare_near")}};
}

template <class Query>
nlohmann::json count_both(const std::vector<Query>& queries) {
  const auto shape_of = [](const Query& q) -> const auto& {
    if constexpr (bench::is_triangle<Query>) {
      return q.triangle;
    } else {
      return q.sphere;
    }
  };
  const auto is_hit = [](const auto& hit) { return hit.kind > std::remove_cvref_t<decltype(hit.kind)>::miss; };
  return {{"hits", count(queries, [&](const Query& q) { return hits(q.ray, shape_of(q)) ? 1U : 0U; })},
          {"intersect", count(queries, [&](const Query& q) { return is_hit(intersect(q.ray, shape_of(q))) ? 1U : 0U; })}};
}

template <class Query>
void count_shares(const char* shape, std::size_t n, std::uint64_t seed, nlohmann::json& out) {
  for (const int percent : bench::degenerate_percents) {
    nlohmann::json counts = count_both(bench::certainty_mix(Query{}, n, percent, seed));
    counts.update({{"shape", shape}, {"mix", "degenerate"}, {"percent", percent}});
    out.push_back(counts);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const long long n = argc > 1 ? std::atoll(argv[1]) : 4096, seed = argc > 2 ? std::atoll(argv[2]) : 1;
  if (n < 1 || seed < 0 || argc > 3) {
    std::fprintf(stderr, "usage: stage_counts [QUERIES [SEED]]: a positive number of queries a mix, 4096 by default\n");
    return 2;
  }
  nlohmann::json out = nlohmann::json::array();
  count_shares<fuzz::RayTriangle<double>>("triangle", static_cast<std::size_t>(n), static_cast<std::uint64_t>(seed), out);
  count_shares<fuzz::RaySphere<double>>("sphere", static_cast<std::size_t>(n), static_cast<std::uint64_t>(seed), out);
  nlohmann::json ties = count_both(bench::tie_triangles(static_cast<std::size_t>(n), static_cast<std::uint64_t>(seed)));
  ties.update({{"shape", "triangle"}, {"mix", "ties"}});
  out.push_back(ties);
  std::printf("%s\n", out.dump(1).c_str());
}
