// The pool of drafts.
#include "fuzz/families/drafts.hpp"

namespace graze::fuzz::construct {

SphereDraft any_sphere_draft(Random& random, int digits) {
  switch (random.below(8)) {
    case 0:
    case 1:
      return quaternion_tangent_draft(random, digits);
    case 2:
      return pythagorean_tangent_draft(random, digits);
    case 3:
      return tangent_third_draft(random, digits);
    case 4:
      return pell_draft(random, digits);
    case 5:
      return sphere_through_origin_draft(random, digits);
    case 6:
      return b_zero_draft(random, digits);
    default:
      return rational_roots_draft(random, digits);
  }
}

TriangleDraft any_triangle_draft(Random& random, int digits) {
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      return edge_corner_draft(random, digits);
    case 3:
    case 4:
      return unimodular_draft(random, digits);
    case 5:
      return coplanar_draft(random, digits);
    case 6:
      return sliver_draft(random, digits);
    default:
      return degenerate_draft(random, digits);
  }
}

Draft any_draft(Random& random, int digits, bool is_triangle) {
  if (is_triangle) return any_triangle_draft(random, digits);
  return any_sphere_draft(random, digits);
}

}  // namespace graze::fuzz::construct
