// The determinants of the triangle filter are within their bounds, in every environment of floating point.
#include "graze/predicates/triangle_filter.hpp"
#include "tests/predicates/exact_terms.hpp"
#include "tests/predicates/hill_climb.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RayTriangle;
using predicates::TriangleTerms;

template <class W, Real T>
TriangleTerms<W> terms_of(const RayTriangle<T>& query) {
  return predicates::triangle_terms<W>(query.ray, query.triangle);
}

/// The shares of the bounds that the errors take.
struct Shares {
  double whole, u, v, w, distance;
  [[nodiscard]] double greatest() const { return std::max({whole, u, v, w, distance}); }
};

template <class W>
Shares shares_of(const TriangleTerms<W>& t, const ExactTriangle& exact) {
  const auto share = [&](W error, W x, const ExactNumber& number) { return share_of(error, t.is_front ? x : -x, number); };
  const ExactNumber w{exact.determinant.value - exact.u.value - exact.v.value, exact.u.unit};
  return {share(t.error, t.whole, exact.determinant), share(t.error, t.u, exact.u), share(t.error, t.v, exact.v),
          share(t.error, t.w, w), share(t.distance_error, t.distance, exact.distance)};
}

template <Real T>
bool is_finite(const RayTriangle<T>& query) {
  bool all = true;
  fuzz::for_each_number(query, [&](const T& x) { all = all && (numeric::is_finite(x) || &x == &query.ray.t_max); });
  return all;
}

/// The greatest share of any; `met` counts where there are bounds to hold.
template <class W, Real T>
double greatest_share(const RayTriangle<T>& query, int& met) {
  if (!is_finite(query)) return 0;
  const ExactTriangle exact = exact_terms(query);
  double greatest = 0;
  for (const Environment& environment : environments) {
    const TriangleTerms<W> t = in_mode(environment, terms_of<W, T>, query);
    if (!t.are_bounded) continue;
    ++met;
    greatest = std::max(greatest, shares_of(t, exact).greatest());
  }
  return greatest;
}

template <class W, Real T>
void require_bounds(const RayTriangle<T>& query, int& met) {
  const double share = greatest_share<W>(query, met);
  if (share <= 1) return;
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(share <= 1);
}

TEST_CASE("The triangle filter's bounds hold on all families") {
  in_each_filter([]<class W, Real T>() {
    int met = 0;
    each_family_query<RayTriangle, T>(2000, [&](const RayTriangle<T>& query) { require_bounds<W>(query, met); });
    CHECK(met > 8 * 10000);
  });
}

TEST_CASE("The triangle filter's bounds hold at the ends of what it takes") {
  in_each_filter([]<class W, Real T>() {
    constexpr std::uint64_t seed = 200;
    CAPTURE(seed);
    fuzz::Random random(seed, "triangle ends", sizeof(T));
    const int least = std::same_as<W, float> ? -19 : std::same_as<T, float> ? -39 : -199;
    const int greatest = std::same_as<W, float> ? 27 : std::same_as<T, float> ? 123 : 196;
    int met = 0;
    for (int round = 0; round < 20000; ++round) {
      RayTriangle<T> query{};
      // Sizes around the least and the greatest that are taken, beside numbers that underflow, or are read as zero.
      const auto set = [&](T& x, int size) {
        x = random_of_size<T>(random, random.one_in(4) ? size - random.between(50, 900) : size);
      };
      const int positions = random.one_in(2) ? least : greatest;
      const int directions = random.one_in(2) ? least : greatest;
      for (T* x : {&query.ray.direction.x, &query.ray.direction.y, &query.ray.direction.z}) set(*x, directions);
      for (Vec3<T>* v : {&query.ray.origin, &query.triangle.a, &query.triangle.b, &query.triangle.c}) {
        for (T* x : {&v->x, &v->y, &v->z}) set(*x, positions);
      }
      require_bounds<W>(query, met);
    }
    CHECK(met > 8 * 5000);
  });
}

/// The greatest share of one term over the rounding modes.
template <class Term>
void climb_term(std::string_view name, Term term) {
  climb<RayTriangle<double>>(name, 60000, [&](const RayTriangle<double>& query) {
    const ExactTriangle exact = exact_terms(query);
    double greatest = 0;
    for (const FloatMode mode : rounding_modes) {
      const TriangleTerms<double> t = in_mode({mode, false}, terms_of<double, double>, query);
      if (t.are_bounded) greatest = std::max(greatest, term(shares_of(t, exact)));
    }
    return greatest;
  });
}

TEST_CASE("The triangle filter's bounds hold where a search makes them tight") {
  climb_term("triangle determinant", [](const Shares& shares) { return shares.whole; });
  climb_term("triangle u", [](const Shares& shares) { return shares.u; });
  climb_term("triangle v", [](const Shares& shares) { return shares.v; });
  climb_term("triangle w", [](const Shares& shares) { return shares.w; });
  climb_term("triangle distance", [](const Shares& shares) { return shares.distance; });
}

TEST_CASE("The distance, of three rounded differences, errs by eight units") {
  const RayTriangle<double> query{{{0x1p-134, -0x1p-64, 1}, {1, 1, 1}},
                                  {{-0x1p-104, -0x1p-114, -0x1p-64}, {1, 0x1p-164, -0x1p-54}, {-0x1p-84, 1, -0x1p-154}}};
  const ExactTriangle exact = exact_terms(query);
  const TriangleTerms<double> upward = in_mode({FloatMode::upward, false}, terms_of<double, double>, query);
  CHECK(share_of(8 * numeric::unit, upward.is_front ? upward.distance : -upward.distance, exact.distance) > 0.9999);
  int met = 0;
  CHECK(greatest_share<double>(query, met) <= 1);
  CHECK(met == 8);
}

}  // namespace
}  // namespace graze::test
