// Whether a surface is closed: each directed edge as often as its reverse, corners being the same where their coordinates are.
#include <algorithm>
#include <array>
#include <tuple>

#include "scene/build.hpp"

namespace graze::scene {
namespace {

/// A corner, ordered by its coordinates.
struct Corner {
  std::int64_t key[3];
  std::uint32_t primitive;
  std::uint32_t corner;

  [[nodiscard]] bool is_before(const Corner& other) const noexcept {
    return std::lexicographical_compare(key, key + 3, other.key, other.key + 3);
  }
};

/// An edge between numbered points, the lesser first.
struct Edge {
  std::uint32_t low, high;
  std::uint32_t primitive : 30;
  std::uint32_t edge : 2;  ///< 0, 1, 2: from a, b, c
  bool is_reversed;

  [[nodiscard]] bool is_beside(const Edge& other) const noexcept { return low == other.low && high == other.high; }
};

template <Real T>
std::vector<Corner> corners_of(const Content<T>& content) {
  std::vector<Corner> out;
  for (std::size_t p = 0; p < content.parts.size(); ++p) {
    const auto* mesh = std::get_if<Mesh<T>>(&content.parts[p]);
    if (mesh == nullptr) continue;
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const Vec3<T>& v = mesh->points[mesh->triangles[i][c]];
        using numeric::order_key;
        out.push_back({{order_key(v.x), order_key(v.y), order_key(v.z)}, static_cast<std::uint32_t>(content.first[p] + i), c});
      }
    }
  }
  return out;
}

/// The numbers of the corners of each primitive, equal where their coordinates are.
std::vector<std::array<std::uint32_t, 3>> numbers_of(std::vector<Corner>& corners, std::size_t primitives) {
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.is_before(b); });
  std::vector<std::array<std::uint32_t, 3>> numbers(primitives);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i > 0 && corners[i - 1].is_before(corners[i])) ++number;
    numbers[corners[i].primitive][corners[i].corner] = number;
  }
  return numbers;
}

}  // namespace

template <Real T>
BuildStatus check_closed(const Content<T>& content) {
  std::vector<Corner> corners = corners_of(content);
  const std::vector<std::array<std::uint32_t, 3>> numbers = numbers_of(corners, content.size());
  std::vector<Edge> edges;
  edges.reserve(corners.size());
  for (const Corner& c : corners) {
    const std::uint32_t from = numbers[c.primitive][c.corner], to = numbers[c.primitive][(c.corner + 1) % 3];
    if (from == to) continue;  // its own reverse
    edges.push_back({std::min(from, to), std::max(from, to), c.primitive, c.corner, from > to});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tuple(a.low, a.high, a.primitive, a.edge) < std::tuple(b.low, b.high, b.primitive, b.edge);
  });
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    std::int64_t balance = 0;
    for (end = begin; end < edges.size() && edges[end].is_beside(edges[begin]); ++end) {
      balance += edges[end].is_reversed ? -1 : 1;
    }
    if (balance == 0) continue;
    const Edge& open = *std::find_if(edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.end(),
                                     [&](const Edge& e) { return e.is_reversed == (balance < 0); });
    const std::uint32_t part = content.part_of(open.primitive);
    return {BuildError::open_edge, part, open.primitive - content.first[part], open.edge};
  }
  return {};
}

template BuildStatus check_closed(const Content<float>&);
template BuildStatus check_closed(const Content<double>&);

}  // namespace graze::scene
