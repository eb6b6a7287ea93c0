// The list of families.
#include "fuzz/family.hpp"

#include <array>

#include "fuzz/families/registry.hpp"

namespace graze::fuzz {

std::span<const Family> families() {
  using namespace construct;
  static const std::array all{
      quaternion_tangent_family(),
      pythagorean_tangent_family(),
      tangent_third_family(),
      pell_family(),
      unimodular_family(),
      origin_on_surface_family(),
      b_zero_family(),
      a_extreme_family(),
      far_small_family(),
      edge_corner_family(),
      fan_family(),
      aimed_family(),
      origin_zero_family(),
      coplanar_family(),
      sliver_family(),
      degenerate_family(),
      rounding_family(),
      near_tie_family(),
      interval_family(),
      range_family(),
      lattice_family(),
      implicit_family(),
      invalid_family(),
      random_family(),
  };
  return all;
}

const Family* find_family(std::string_view name) {
  for (const Family& family : families()) {
    if (family.name == name) return &family;
  }
  return nullptr;
}

}  // namespace graze::fuzz
