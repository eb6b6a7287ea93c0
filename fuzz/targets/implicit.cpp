// Points against lines, planes and spheres.
#include "fuzz/targets/case_target.hpp"

namespace graze::fuzz {

const QueryGroup target_group = QueryGroup::implicit;

}  // namespace graze::fuzz
