// The way of a ray through the hierarchy.
#pragma once

#include <array>

#include "scene/box_ray.hpp"
#include "scene/leaf.hpp"

namespace graze::scene {

/// Which children's boxes the ray meets, as bits, and where it enters them.
struct Met {
  unsigned children;
  float entry[width];
};

[[nodiscard]] inline Met meet_boxes(const BoxRay& ray, const Node& node) noexcept {
  Met met;
  float first[width], last[width];
  for (int i = 0; i < width; ++i) {
    first[i] = 0;
    last[i] = ray.high;
  }
  for (int k = 0; k < 3; ++k) {
    const bool is_backward = ray.reciprocal[k] < 0;
    const float *near = node.bounds[is_backward][k], *far = node.bounds[!is_backward][k];
    for (int i = 0; i < width; ++i) {
      const float n = near[i] * ray.reciprocal[k] - ray.near_offset[k], m = far[i] * ray.reciprocal[k] - ray.far_offset[k];
      first[i] = n > first[i] ? n : first[i];
      last[i] = m < last[i] ? m : last[i];
    }
  }
  met.children = 0;
  for (int i = 0; i < width; ++i) {
    met.entry[i] = first[i];
    met.children |= static_cast<unsigned>(first[i] <= last[i] * (1 + BoxRay::slack)) << i;
  }
  return met;
}

/// Levels of the hierarchy, by construction (build.cpp).
inline constexpr int deepest = 100;

/// Visits the leaves that the ray meets, nearer ones first as far as their boxes tell, until leaf(child) returns true. It may
/// shorten the ray.
template <Real T, class Tally, class Leaf>
inline void walk(const Query<T, Tally>& query, BoxRay& ray, Leaf leaf) noexcept {
  if (query.data.nodes.empty()) return;
  struct Entry {
    Child child;
    float entry;
  };
  std::array<Entry, std::size_t(deepest) * (width - 1) + 1> stack;
  std::size_t size = 0;
  Child next = Child::node(0);
  while (true) {
    if (next.is_leaf()) {
      query.tally.template add<&Statistics::leaves>(1);
      if (leaf(next)) return;
    } else {
      query.tally.template add<&Statistics::nodes>(1);
      const Node& node = query.data.nodes[next.index()];
      const Met met = meet_boxes(ray, node);
      // The farthest goes on the stack first: an insertion sort, for there are few.
      const std::size_t base = size;
      for (unsigned rest = met.children; rest != 0; rest &= rest - 1) {
        const int i = __builtin_ctz(rest);
        if (node.children[i].is_nothing()) continue;
        std::size_t at = size++;
        for (; at > base && stack[at - 1].entry < met.entry[i]; --at) stack[at] = stack[at - 1];
        stack[at] = {node.children[i], met.entry[i]};
      }
    }
    do {
      if (size == 0) return;
      --size;
    } while (stack[size].entry > ray.high);
    next = stack[size].child;
  }
}

}  // namespace graze::scene
