// Ray and sphere: permuting and reflecting axes, and moving along the ray, changes nothing that it should not.
#include "fuzz/case_text.hpp"
#include "fuzz/same_bits.hpp"
#include "graze/sphere.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/isometry.hpp"

namespace graze::test {
namespace {

using fuzz::RaySphere;

TEST_CASE("Ray and sphere: no permutation or reflection of axes changes a bit") {
  in_both_formats([]<Real T>() {
    each_family_query<RaySphere, T>(150, [](const RaySphere<T>& query) {
      const SphereHit<T> expected = intersect(query.ray, query.sphere);
      each_isometry([&](const Isometry& isometry) {
        const RaySphere<T> turned = isometry(query);
        const SphereHit<T> found = intersect(turned.ray, turned.sphere);
        if (fuzz::same_bits(found, expected) && hits(turned.ray, turned.sphere) == hits(query.ray, query.sphere)) return;
        CAPTURE(found, expected);
        INFO(fuzz::format_case(fuzz::Case<T>(turned)));
        REQUIRE(false);
      });
    });
  });
}

TEST_CASE("Ray and sphere: a ray turned around has the roots of other sign in other order") {
  in_both_formats([]<Real T>() {
    each_family_query<RaySphere, T>(600, [](const RaySphere<T>& query) {
      constexpr T greatest = std::numeric_limits<T>::max();
      const Vec3<T>& d = query.ray.direction;
      const SphereHit<T> hit = intersect(Ray<T>{query.ray.origin, d, -greatest, greatest}, query.sphere);
      const SphereHit<T> turned = intersect(Ray<T>{query.ray.origin, {-d.x, -d.y, -d.z}, -greatest, greatest}, query.sphere);
      SphereHit<T> expected = hit;
      const auto negative = [](T t) { return t == T(0) ? T(0) : -t; };
      if (hit.root == Root::first) expected.root = Root::second;
      if (hit.root == Root::second) expected.root = Root::first;
      for (int i = 0; i < hit.count(); ++i) expected.t[i] = negative(hit.t[hit.count() - 1 - i]);
      if (fuzz::same_bits(turned, expected)) return;
      CAPTURE(turned, expected);
      INFO(fuzz::format_case(fuzz::Case<T>(query)));
      REQUIRE(fuzz::same_bits(turned, expected));
    });
  });
}

}  // namespace
}  // namespace graze::test
