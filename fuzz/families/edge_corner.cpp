// edge-corner. P = a + (i E1 + j E2) / q and e = P - tau d: the ray passes a corner (i = j = 0 ...), an edge (i = 0, j = 0,
// i + j = q), the face, or one lattice step beside an edge. q is a power of two, a multiple of three (u = 1/3) or any odd
// number; everything is multiplied by q to stay on the lattice. Products of coordinates have twice the digits of the mantissa,
// and the edge's determinant is 0 all the same.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

TriangleDraft edge_corner_draft(Random& random, int digits) {
  const int part_bits = random.between(1, digits / 3);
  const int edge_bits = choose_bits(random, 1, digits - 3 - part_bits);
  const int direction_bits = choose_bits(random, 1, digits - 4);
  const int along_bits = choose_bits(random, 1, digits - 3 - direction_bits);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = choose_vector(random, edge_bits);
  aim.point = choose_point(random, part_bits);
  aim.d = choose_vector(random, direction_bits);
  aim.tau = choose_natural(random, along_bits);
  aim.alpha = choose_factor(random, digits - direction_bits);
  return aimed_triangle(aim);
}

namespace {
struct EdgeCorner {
  static constexpr std::string_view name = "edge-corner";
  static constexpr std::string_view attacks = "rays through edges and corners, and a lattice step beside them";
  static constexpr Note note{"the three edge signs rounded, each by itself",
                             "rays lost between two triangles, or counted twice at one edge",
                             "jbikker/tinybvh issue 168; mrdoob/three.js pull request 33661; Oblikovati/Oblikovati issue 2146"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.mixed_axes = index % 16 >= 12;
    return finish<T>(edge_corner_draft(random, digits<T>), random, index, plan);
  }
};
}  // namespace

Family edge_corner_family() {
  return family_of<EdgeCorner>();
}

}  // namespace graze::fuzz::construct
