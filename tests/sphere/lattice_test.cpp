// Every ray through two points of a small lattice against every sphere of integer data. All of the larger lattice:
//   bin/test_sphere "[exhaustive]"
#include "tests/support/lattice.hpp"

#include "tests/support/agreement.hpp"

namespace graze::test {
namespace {

/// Points from {low, ..., low + side - 1}^3, radii below `radii`; one query in `stride` of all.
template <Real T>
void require_agreement_on_lattice(int low, std::uint64_t side, std::uint64_t radii, std::uint64_t stride) {
  const std::uint64_t points = side * side * side, count = points * points * points * radii;
  CAPTURE(low, side, radii, stride);
  for (std::uint64_t index = 0; index < count; index += stride) {
    Digits digits(index);
    fuzz::RaySphere<T> query;
    query.ray.origin = digits.point<T>(low, side);
    const Vec3<T> through = digits.point<T>(low, side), &e = query.ray.origin;
    query.ray.direction = {through.x - e.x, through.y - e.y, through.z - e.z};
    query.sphere.center = digits.point<T>(low, side);
    query.sphere.radius = T(digits.next(radii));
    set_range(query.ray, index / stride);
    require_agreement(fuzz::Case<T>(query));
  }
}

TEST_CASE("Every ray and sphere on a lattice three wide") {
  require_agreement_on_lattice<float>(0, 3, 4, 1);
  require_agreement_on_lattice<double>(0, 3, 4, 1);
}

TEST_CASE("Rays and spheres on a lattice five wide, in a stride") {
  require_agreement_on_lattice<float>(-2, 5, 6, 197);
  require_agreement_on_lattice<double>(-2, 5, 6, 101);
}

TEST_CASE("Every ray and sphere on a lattice five wide", "[.exhaustive]") {
  require_agreement_on_lattice<float>(-2, 5, 6, 1);
  require_agreement_on_lattice<double>(-2, 5, 6, 1);
}

}  // namespace
}  // namespace graze::test
