// Point and implicit surface at both ends of the range of numbers, and at every scale between.
#include <cmath>

#include "fuzz/case_numbers.hpp"
#include "fuzz/random.hpp"
#include "graze/implicit.hpp"
#include "tests/support/agreement.hpp"
#include "tests/support/answers.hpp"
#include "tests/support/scaled.hpp"

namespace graze::test {
namespace {

constexpr Side negative{Status::ok, Sign::negative}, on{Status::ok, Sign::zero}, positive{Status::ok, Sign::positive};

TEST_CASE("The least and the largest numbers have sides like others") {
  in_both_formats([]<Real T>() {
    const T least = kLeast<T>, big = kGreatest<T>;
    CHECK(side(Vec2<T>{least, least}, Line<T>{least, -least, 0}) == on);
    CHECK(side(Vec2<T>{least, 2 * least}, Line<T>{least, -least, 0}) == negative);
    CHECK(side(Vec2<T>{big, big}, Line<T>{big, -big, 0}) == on);
    CHECK(side(Vec2<T>{big, std::nextafter(big, T(0))}, Line<T>{big, -big, 0}) == positive);
    CHECK(side(Vec2<T>{least, 0}, Line<T>{least, 0, -least}) == negative);
    CHECK(side(Vec2<T>{least, 0}, Line<T>{1, 0, -least}) == on);
    CHECK(side(Vec3<T>{3 * least, 0, 4 * least}, Sphere<T>{{0, 0, 0}, 5 * least}) == on);
    CHECK(side(Vec3<T>{3 * least, least, 4 * least}, Sphere<T>{{0, 0, 0}, 5 * least}) == positive);
    CHECK(side(Vec3<T>{big, 0, 0}, Sphere<T>{{-big, 0, 0}, big}) == positive);
    CHECK(side(Vec3<T>{big, 0, 0}, Sphere<T>{{0, 0, 0}, big}) == on);
    CHECK(side(Vec3<T>{big, least, 0}, Sphere<T>{{0, 0, 0}, big}) == positive);
    CHECK(side(Vec3<T>{std::nextafter(big, T(0)), least, 0}, Sphere<T>{{0, 0, 0}, big}) == negative);
  });
}

/// All lengths times a power of two: f is times its square, and the sign the same.
template <Real T>
void check_scaled(const fuzz::PointSphere<T>& query, int exponent) {
  const fuzz::PointSphere<T> large = scaled(query, exponent);
  const Side found = side(large.point, large.sphere), expected = side(query.point, query.sphere);
  if (found == expected) return;
  CAPTURE(exponent, found, expected);
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(found == expected);
}

TEST_CASE("A power of two on all lengths changes no side of a sphere") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 16;
    CAPTURE(seed);
    fuzz::Random random(seed, "scaled points", sizeof(T));
    int met[3] = {};
    for (int exponent = lowest_exponent<T>; exponent <= highest_exponent<T>; ++exponent) {
      for (int i = 0; i < 8; ++i) {
        fuzz::PointSphere<T> query{};
        fuzz::for_each_number(query, [&](T& x) { x = T(random.between(-4, 4)); });
        query.sphere.radius = std::fabs(query.sphere.radius);
        ++met[static_cast<int>(side(query.point, query.sphere).sign) + 1];
        check_scaled(query, exponent);
      }
    }
    for (const int count : met) CHECK(count > 10);
  });
}

TEST_CASE("Powers of two on every number apart, against the oracle") {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 17;
    CAPTURE(seed);
    fuzz::Random random(seed, "stretched points", sizeof(T));
    const auto ask = [&](auto query) {
      const int all = random.between(lowest_exponent<T>, highest_exponent<T>);
      fuzz::for_each_number(query, [&](T& x) {
        x = std::ldexp(T(random.between(-3, 3)),
                       random.one_in(3) ? random.between(lowest_exponent<T>, highest_exponent<T>) : all);
      });
      if constexpr (requires { query.sphere; }) query.sphere.radius = std::fabs(query.sphere.radius);
      require_agreement_in_all_environments(fuzz::Case<T>(query));
    };
    for (int i = 0; i < 3000; ++i) {
      ask(fuzz::PointLine<T>{});
      ask(fuzz::PointPlane<T>{});
      ask(fuzz::PointSphere<T>{});
    }
  });
}

}  // namespace
}  // namespace graze::test
