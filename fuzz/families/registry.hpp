// The families of this folder, and how a struct becomes one.
#pragma once

#include "fuzz/family.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz::construct {

/// Makes a family of a struct with `name`, `attacks`, `note` and `make<T>(random, index)`.
template <class Maker, Real T>
LabelledCase<T> make_case(std::uint64_t seed, std::uint64_t index) {
  Random random(seed, Maker::name, index);
  return Maker::template make<T>(random, index);
}
template <class Maker>
Family family_of() {
  return {Maker::name, Maker::attacks, Maker::note, &make_case<Maker, float>, &make_case<Maker, double>};
}

Family quaternion_tangent_family();
Family pythagorean_tangent_family();
Family tangent_third_family();
Family pell_family();
Family unimodular_family();
Family origin_on_surface_family();
Family b_zero_family();
Family a_extreme_family();
Family far_small_family();
Family edge_corner_family();
Family fan_family();
Family aimed_family();
Family origin_zero_family();
Family coplanar_family();
Family sliver_family();
Family degenerate_family();
Family rounding_family();
Family near_tie_family();
Family interval_family();
Family range_family();
Family lattice_family();
Family implicit_family();
Family invalid_family();
Family random_family();

}  // namespace graze::fuzz::construct
