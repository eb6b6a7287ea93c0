// What drafts of spheres and triangles do differently.
#include "fuzz/families/draft.hpp"

#include <algorithm>

namespace graze::fuzz::construct {

int position_bits(const SphereDraft& draft) {
  return std::max({bit_length(draft.origin), bit_length(draft.center), bit_length(draft.radius)});
}

int position_bits(const TriangleDraft& draft) {
  int most = bit_length(draft.origin);
  for (const IntVec& corner : draft.corner) most = std::max(most, bit_length(corner));
  return most;
}

TriangleKind opposite_edge(int corner) {
  return corner == 0 ? TriangleKind::edge_bc : corner == 1 ? TriangleKind::edge_ca : TriangleKind::edge_ab;
}

TriangleKind vertex(int corner) {
  return corner == 0 ? TriangleKind::vertex_a : corner == 1 ? TriangleKind::vertex_b : TriangleKind::vertex_c;
}

void permute_corners(TriangleDraft& draft, Random& random) {
  const int shift = random.between(0, 2);
  const bool mirror = random.one_in(2);
  const std::array<IntVec, 3> old = draft.corner;
  const std::optional<TriangleKind> promised = draft.promise.kind;
  for (int corner = 0; corner < 3; ++corner) {
    const int target = ((mirror ? 3 - corner : corner) + shift) % 3;
    draft.corner[static_cast<std::size_t>(target)] = old[static_cast<std::size_t>(corner)];
    if (promised == vertex(corner)) draft.promise.kind = vertex(target);
    if (promised == opposite_edge(corner)) draft.promise.kind = opposite_edge(target);
  }
}

}  // namespace graze::fuzz::construct
