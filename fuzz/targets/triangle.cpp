// Rays against triangles.
#include "fuzz/targets/case_target.hpp"

namespace graze::fuzz {

const QueryGroup target_group = QueryGroup::ray_triangle;

}  // namespace graze::fuzz
