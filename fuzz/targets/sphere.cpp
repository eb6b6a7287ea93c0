// Rays against spheres.
#include "fuzz/targets/case_target.hpp"

namespace graze::fuzz {

const QueryGroup target_group = QueryGroup::ray_sphere;

}  // namespace graze::fuzz
