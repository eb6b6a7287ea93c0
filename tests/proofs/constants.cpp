// The kernel's error constants against those of the proofs, so that code and proof cannot drift apart.
//   proof_constants SCRIPT...    every line `NAME = MbE;  # bound: FILE` (or `domain`) of the scripts must be the kernel's
//   constant of that
//                                name, M 2^E, and every constant of the kernel must be proven as a bound or assumed as a domain
//                                there
// Exit status: 0 they agree, 1 they do not, 2 a script cannot be read.
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "batch/bounds.hpp"
#include "graze/predicates/implicit_filter.hpp"
#include "graze/predicates/sphere_filter.hpp"
#include "graze/predicates/triangle_filter.hpp"
#include "numeric/approximation.hpp"
#include "numeric/lattice.hpp"
#include "rounding/error_bounds.hpp"

namespace {

using namespace graze;

const std::map<std::string, double> kernel_constants{
    {"double_unit", numeric::unit_of<double>},
    {"float_unit", numeric::unit_of<float>},
    {"double_low", numeric::Ordinary<double, double>::low},
    {"double_high", numeric::Ordinary<double, double>::high},
    {"double_bound_high", numeric::Ordinary<double, double>::bound_high},
    {"mixed_low", numeric::Ordinary<double, float>::low},
    {"mixed_high", numeric::Ordinary<double, float>::high},
    {"mixed_bound_high", numeric::Ordinary<double, float>::bound_high},
    {"float_low", numeric::Ordinary<float, float>::low},
    {"float_high", numeric::Ordinary<float, float>::high},
    {"float_bound_high", numeric::Ordinary<float, float>::bound_high},
    {"triangle_error", predicates::triangle_error},
    {"sphere_c_error", predicates::sphere_c_error},
    {"sphere_discriminant_error", predicates::sphere_discriminant_error},
    {"sphere_perpendicular_error", predicates::sphere_perpendicular_error},
    {"sphere_refined_error", predicates::sphere_refined_error},
    {"sphere_place_error", predicates::sphere_place_error},
    {"line_error", predicates::line_error},
    {"plane_error", predicates::plane_error},
    {"double_underflow", predicates::underflow_share<double>},
    {"float_underflow", predicates::underflow_share<float>},
    {"margin_share", rounding::margin_share},
    {"float_sum_error", rounding::float_sum_error},
    {"pair_determinant_error", rounding::pair_determinant_error},
    {"pair_quotient_error", rounding::pair_quotient_error},
    {"quotient_error", rounding::quotient_error},
    {"certainty", rounding::certainty},
    {"second_order", rounding::second_order},
    {"root_share", rounding::root_share},
    {"pair_steps", rounding::pair_steps},
    {"double_steps", rounding::double_steps},
    {"pair_c_error", rounding::pair_c_error},
    {"pair_discriminant_error", rounding::pair_discriminant_error},
    {"lattice_fineness", numeric::lattice_fineness},
    {"batch_float_low", batch::Bounds<float>::low},
    {"batch_float_high", batch::Bounds<float>::high},
    {"batch_float_most_squares", batch::Bounds<float>::most_squares},
    {"batch_double_low", batch::Bounds<double>::low},
    {"batch_double_high", batch::Bounds<double>::high},
    {"batch_double_most_squares", batch::Bounds<double>::most_squares},
    {"batch_determinant_error", batch::determinant_error},
    {"batch_combination_share", batch::combination_share},
    {"batch_sphere_c_error", batch::sphere_c_error},
    {"batch_sphere_discriminant_error", batch::sphere_discriminant_error},
    {"batch_sphere_place_error", batch::sphere_place_error},
    {"batch_unit_sphere_error", batch::unit_sphere_error},
    {"batch_sheared_error", batch::sheared_error},
    {"approximation_slack", static_cast<double>(numeric::Approximation::slack)},
};

/// Whether all of the script's constants are the kernel's; their names go to `named`.
bool agrees(const std::string& path, std::istream& script, std::set<std::string>& named) {
  static const std::regex constant("([a-z0-9_]+) = ([0-9]+)b(-?[0-9]+);\\s*# (bound|domain): .*");
  bool is_right = true, has_bound = false;
  for (std::string line; std::getline(script, line);) {
    std::smatch parts;
    if (!std::regex_match(line, parts, constant)) continue;
    has_bound = has_bound || parts[4] == "bound";
    named.insert(parts[1]);
    const auto at = kernel_constants.find(parts[1]);
    if (at == kernel_constants.end()) {
      std::cerr << path << ": the kernel has no constant " << parts[1] << '\n';
      is_right = false;
    } else if (at->second != std::ldexp(std::stod(parts[2]), std::stoi(parts[3]))) {
      std::cerr << path << ": " << parts[1] << " is " << parts[2] << "b" << parts[3] << ", in the kernel " << std::hexfloat
                << at->second << '\n';
      is_right = false;
    }
  }
  if (!has_bound) std::cerr << path << ": proves no bound\n";
  return is_right && has_bound;
}

}  // namespace

int main(int argc, char** argv) {
  std::set<std::string> named;
  bool is_right = true;
  for (int i = 1; i < argc; ++i) {
    std::ifstream script(argv[i]);
    if (!script) {
      std::cerr << argv[i] << ": cannot be read\n";
      return 2;
    }
    is_right &= agrees(argv[i], script, named);
  }
  for (const auto& [name, value] : kernel_constants) {
    if (named.contains(name)) continue;
    std::cerr << name << ": no script speaks of it\n";
    is_right = false;
  }
  if (is_right) std::cout << named.size() << " constants are those of " << argc - 1 << " proofs\n";
  return is_right ? 0 : 1;
}
