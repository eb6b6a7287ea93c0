// Correct rounding at its edges: ties, subnormal results, overflow, the sign of zero. All by hand.
#include "tests/oracle/both_oracles.hpp"

namespace graze::oracle {
namespace {

/// The t at which the ray from (start, 0, 0) in direction (length, 0, 0) crosses the plane x = wall: (wall - start) / length.
template <Real T>
[[nodiscard]] T quotient(const Oracle& oracle, T wall, T start, T length) {
  const Triangle<T> triangle{{wall, -1, -1}, {wall, 1, -1}, {wall, 0, 1}};
  const Ray<T> ray{{start, 0, 0}, {length, 0, 0}, -kGreatest<T>};
  const TriangleHit<T> hit = oracle.answer(ray, triangle);
  REQUIRE(hit.kind == TriangleKind::face);
  return hit.t;
}

/// The same number as the parameter of a sphere of radius 0, which is B / A.
template <Real T>
[[nodiscard]] T double_root(const Oracle& oracle, T center, T start, T length) {
  const Ray<T> ray{{start, 0, 0}, {length, 0, 0}, -kGreatest<T>};
  const SphereHit<T> hit = oracle.answer(ray, Sphere<T>{{center, 0, 0}, 0});
  REQUIRE(hit.kind == SphereKind::tangent);
  return hit.t[0];
}

template <Real T>
void check_ahead(const Oracle& oracle, T wall, T start, T length, T expected) {
  CHECK(quotient(oracle, wall, start, length) == expected);
  CHECK(double_root(oracle, wall, start, length) == expected);
}

/// The same for the ray that looks away. Not for overflow: a range has no room below the least number.
template <Real T>
void check(const Oracle& oracle, T wall, T start, T length, T expected) {
  check_ahead(oracle, wall, start, length, expected);
  CHECK(quotient(oracle, wall, start, -length) == -expected);
  CHECK(double_root(oracle, wall, start, -length) == -expected);
}

template <Real T>
inline constexpr T kTwoToDigits = 2 / std::numeric_limits<T>::epsilon();  ///< the first number whose successor is 2 away

TEST_CASE("Ties go to even") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T n = kTwoToDigits<T>;
    check<T>(oracle, n, -1, 1, n);
    check<T>(oracle, n, -3, 1, n + 4);
    check<T>(oracle, n, -5, 1, n + 4);
    check<T>(oracle, n, -1, 4, n / 4);
    // A hair off the tie, in either direction.
    check<T>(oracle, n, std::nextafter(T(-1), T(-2)), 1, n + 2);
    check<T>(oracle, n, std::nextafter(T(-3), T(0)), 1, n + 2);
    // The tie below a power of two, where the spacing changes.
    check<T>(oracle, n, T(0.5), 1, n);
    check<T>(oracle, n, T(1.5), 1, n - 2);
  });
}

TEST_CASE("Next to a tie, by so little that no head of bits shows it") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T n = kTwoToDigits<T>;
    const T least = kLeast<T>;
    // n^2 / (n - 1) = n + 1 + 1 / n + ...
    check_ahead<T>(oracle, n * n, 0, n - 1, n + 2);
    // The plane x + y = n, met at t = n + 1 - y.
    const Triangle<T> tilted{{n + 4, -4, -4}, {n - 4, 4, -4}, {n, 0, 4}};
    CHECK(oracle.answer(Ray<T>{{-1, -least, 0}, {1, 0, 0}}, tilted).t == n + 2);
    CHECK(oracle.answer(Ray<T>{{-1, 0, 0}, {1, 0, 0}}, tilted).t == n);
    CHECK(oracle.answer(Ray<T>{{-1, least, 0}, {1, 0, 0}}, tilted).t == n);
    // 5001^2 - 4900^2 = 1000^2 + 1, the root of which is 1000 and half a thousandth: n + 1 less that, n + 2001 more.
    const Sphere<T> sphere{{n, 4900, 0}, 5001};
    CHECK(oracle.answer(Ray<T>{{-1001, 0, 0}, {1, 0, 0}}, sphere) == secant<T>(OriginSide::outside, n, n + 2002));
    // n + 1 -+ sqrt(3) least.
    const Sphere<T> bead{{n, 0, 0}, 2 * least};
    CHECK(oracle.answer(Ray<T>{{-1, least, 0}, {1, 0, 0}}, bead) == secant<T>(OriginSide::outside, n, n + 2));
  });
}

TEST_CASE("Subnormal results") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T least = kLeast<T>;
    check<T>(oracle, 3 * least, 0, 2, 2 * least);
    check<T>(oracle, 5 * least, 0, 2, 2 * least);
    check<T>(oracle, 5 * least, 0, std::nextafter(T(2), T(1)), 3 * least);
    check<T>(oracle, 7 * least, 0, 3, 2 * least);
    // The greatest subnormal number, the tie above it, and the normal number that a carry makes of it.
    const T normal = std::numeric_limits<T>::min();
    check<T>(oracle, normal - least, 0, 1, normal - least);
    check<T>(oracle, 2 * normal - least, 0, 2, normal);
    check<T>(oracle, 2 * normal - 3 * least, 0, 2, normal - 2 * least);
  });
}

TEST_CASE("What rounds to zero is +0, from either side") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T least = kLeast<T>;
    for (const T wall : {T(0), T(-0.0), least, -least}) {
      for (const T length : {T(2), T(-2), T(3), kGreatest<T>, -kGreatest<T>}) {
        CHECK_FALSE(std::signbit(quotient<T>(oracle, wall, 0, length)));
        CHECK(quotient<T>(oracle, wall, 0, length) == 0);
        CHECK_FALSE(std::signbit(double_root<T>(oracle, wall, 0, length)));
        CHECK(double_root<T>(oracle, wall, 0, length) == 0);
      }
    }
    check<T>(oracle, least, 0, std::nextafter(T(2), T(1)), least);
  });
}

TEST_CASE("Overflow begins half a spacing above the greatest number") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T big = kGreatest<T>;
    const T half_spacing = (big - std::nextafter(big, T(0))) / 2;
    check_ahead<T>(oracle, big, -half_spacing, 1, kInfinity<T>);
    check_ahead<T>(oracle, big, -std::nextafter(half_spacing, T(0)), 1, big);
    check_ahead<T>(oracle, big, 0, 1 - std::numeric_limits<T>::epsilon() / 2, kInfinity<T>);
    check_ahead<T>(oracle, big, -big, 1, kInfinity<T>);
    check_ahead<T>(oracle, 1, 0, kLeast<T>, kInfinity<T>);
  });
}

TEST_CASE("Roots of a quadratic round as quotients do") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const T n = kTwoToDigits<T>;
    const auto roots = [&](T center, T radius, T start, T length) {
      return oracle.answer(Ray<T>{{start, 0, 0}, {length, 0, 0}, -kGreatest<T>}, Sphere<T>{{center, 0, 0}, radius});
    };
    // n + 1 -+ 2 are both ties, n + 3 goes up and n - 1 is a number.
    CHECK(roots(n, 2, -1, 1) == secant<T>(OriginSide::outside, n - 1, n + 4));
    CHECK(roots(n, 2, -1, -1) == secant<T>(OriginSide::outside, -(n + 4), -(n - 1)));
    CHECK(roots(2 * kLeast<T>, kLeast<T>, 0, 2) == secant<T>(OriginSide::outside, 0, 2 * kLeast<T>));
    CHECK(roots(kGreatest<T>, kGreatest<T> / 2, -kGreatest<T>, 1) ==
          secant<T>(OriginSide::outside, kInfinity<T>, kInfinity<T>));
    // Irrational: 1 -+ sqrt(1 - 1/4).
    const SphereHit<T> hit = oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{1, T(0.5), 0}, 1});
    const bool is_double = std::same_as<T, double>;
    CHECK(hit.t[0] == T(is_double ? 0x1.126145e9ecd56p-3 : 0x1.126146p-3));
    CHECK(hit.t[1] == T(is_double ? 0x1.ddb3d742c2655p+0 : 0x1.ddb3d8p+0));
  });
}

TEST_CASE("Two roots may round to one number") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const SphereHit<T> hit = oracle.answer(Ray<T>{{0, 0, 0}, {1, 0, 0}}, Sphere<T>{{1, 0, 0}, kLeast<T>});
    CHECK(hit == secant<T>(OriginSide::outside, 1, 1));
  });
}

TEST_CASE("u and v round as t does") {
  everywhere([]<Real T>(const Oracle& oracle) {
    const auto hit_at = [&](T x, T y, T size) {
      return oracle.answer(Ray<T>{{x, y, 1}, {0, 0, -1}}, Triangle<T>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}});
    };
    const T least = kLeast<T>;
    CHECK(hit_at(least, least, 2) == at_point<T>(TriangleKind::face, Facing::front, 1, 0, 0));
    CHECK(hit_at(3 * least, least, 2) == at_point<T>(TriangleKind::face, Facing::front, 1, 2 * least, 0));
    // On the edge a hair before the corner b: u is below 1 and rounds to it.
    const Triangle<T> long_edge{{-kGreatest<T>, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(oracle.answer(Ray<T>{{0, 0, 1}, {0, 0, -1}}, long_edge) ==
          at_point<T>(TriangleKind::edge_ab, Facing::front, 1, 1, 0));
  });
}

}  // namespace
}  // namespace graze::oracle
