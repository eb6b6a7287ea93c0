// Point and implicit surface against the oracle on all families, in every environment, from two threads.
#include "tests/support/agreement.hpp"

#include "graze/implicit.hpp"
#include "tests/support/isometry.hpp"
#include "tests/support/threads.hpp"
#include "tests/support/tiers.hpp"

namespace graze::test {
namespace {

template <Real T>
constexpr bool is_callable_anywhere =
    noexcept(side(Vec2<T>{}, Line<T>{})) && noexcept(side(Vec3<T>{}, Plane<T>{})) && noexcept(side(Vec3<T>{}, Sphere<T>{}));
static_assert(is_callable_anywhere<float> && is_callable_anywhere<double>);

TEST_CASE("Point and line: the oracle's answer on all families, in every environment") {
  require_agreement_on_families_in_all_environments<fuzz::PointLine>(10000, 3000);
}

TEST_CASE("Point and plane: the oracle's answer on all families, in every environment") {
  require_agreement_on_families_in_all_environments<fuzz::PointPlane>(10000, 3000);
}

TEST_CASE("Point and sphere: the oracle's answer on all families, in every environment") {
  require_agreement_on_families_in_all_environments<fuzz::PointSphere>(10000, 3000);
}

TEST_CASE("Point and sphere: no permutation or reflection of axes changes the side") {
  in_both_formats([]<Real T>() {
    each_family_query<fuzz::PointSphere, T>(1000, [](const fuzz::PointSphere<T>& query) {
      const Side expected = side(query.point, query.sphere);
      each_isometry([&](const Isometry& isometry) {
        const fuzz::PointSphere<T> turned = isometry(query);
        const bool is_same = side(turned.point, turned.sphere) == expected;
        if (!is_same) REQUIRE(is_same);
      });
    });
  });
}

TEST_CASE("Points and surfaces: numbers that fill the widths of the exact stage") {
  require_agreement_at_tier_ends<fuzz::PointLine>(1000);
  require_agreement_at_tier_ends<fuzz::PointPlane>(1000);
  require_agreement_at_tier_ends<fuzz::PointSphere>(1000);
}

TEST_CASE("Points and surfaces: two threads answer as one") {
  require_agreement_between_threads<fuzz::PointPlane, float>(6000);
  require_agreement_between_threads<fuzz::PointSphere, double>(6000);
}

}  // namespace
}  // namespace graze::test
