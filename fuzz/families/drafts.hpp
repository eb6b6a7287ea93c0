// Drafts that other families borrow: exact lattice cases for a format of so many mantissa digits.
#pragma once

#include "fuzz/families/draft.hpp"

namespace graze::fuzz::construct {

[[nodiscard]] SphereDraft quaternion_tangent_draft(Random& random, int digits);
[[nodiscard]] SphereDraft pythagorean_tangent_draft(Random& random, int digits);
[[nodiscard]] SphereDraft tangent_third_draft(Random& random, int digits);
[[nodiscard]] SphereDraft pell_draft(Random& random, int digits);
[[nodiscard]] SphereDraft sphere_through_origin_draft(Random& random, int digits);
[[nodiscard]] SphereDraft b_zero_draft(Random& random, int digits);
[[nodiscard]] SphereDraft rational_roots_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft unimodular_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft edge_corner_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft coplanar_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft sliver_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft degenerate_draft(Random& random, int digits);

/// Any of the above for the shape.
[[nodiscard]] SphereDraft any_sphere_draft(Random& random, int digits);
[[nodiscard]] TriangleDraft any_triangle_draft(Random& random, int digits);
[[nodiscard]] Draft any_draft(Random& random, int digits, bool is_triangle);

}  // namespace graze::fuzz::construct
