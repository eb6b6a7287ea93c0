// Why the oracle asks CGAL for decisions only, and why there are two oracles: a construction of CGAL 5.5 that is wrong.
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

constexpr bool kFaultyVersion = CGAL_VERSION_NR >= 1050500000 && CGAL_VERSION_NR < 1050600000;

TEST_CASE("CGAL 5.5 constructs an intersection of a triangle and a coplanar ray that points away from it") {
  const Kernel::Triangle_3 triangle(Kernel::Point_3(0, 0, 0), Kernel::Point_3(4, 0, 0), Kernel::Point_3(0, 4, 0));
  const Kernel::Ray_3 away(Kernel::Point_3(5, 0, 0), Kernel::Vector_3(1, 0, 0));
  CHECK_FALSE(CGAL::do_intersect(away, triangle));

  const auto part = CGAL::intersection(away, triangle);
  // A version that has mended this passes as well; the known one must show it, or this test shows nothing.
  if (kFaultyVersion) CHECK(bool(part));

  everywhere([]<Real T>(const Oracle& oracle) {
    CHECK(oracle.answer(Ray<T>{{5, 0, 0}, {1, 0, 0}}, Triangle<T>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}) ==
          triangle_miss<T>(Facing::none));
  });
}

}  // namespace
}  // namespace graze::oracle
