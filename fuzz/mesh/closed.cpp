// Whether a mesh is closed, as the contract says it.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

std::vector<OpenEdge> open_edges(const Mesh& mesh) {
  // The first point with the same coordinates stands for all of them.
  std::map<std::tuple<double, double, double>, std::uint32_t> first;
  std::vector<std::uint32_t> same(mesh.points.size());
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const auto& [x, y, z] = mesh.points[i];
    same[i] = first.try_emplace({x + 0.0, y + 0.0, z + 0.0}, i).first->second;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int64_t> balance;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = same[t[k]], to = same[t[(k + 1) % 3]];
      if (from == to) continue;
      ++balance[{from, to}];
      --balance[{to, from}];
    }
  }
  std::vector<OpenEdge> open;
  for (const auto& [edge, n] : balance) {
    if (n > 0) open.push_back({edge.first, edge.second});
  }
  return open;
}

}  // namespace graze::fuzz
