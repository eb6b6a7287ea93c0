// f of an implicit surface is within its bound, and its sign is told only where it is right; in every environment of floating
// point.
#include "graze/predicates/implicit_filter.hpp"
#include "tests/predicates/exact_terms.hpp"
#include "tests/predicates/hill_climb.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::PointLine;
using fuzz::PointPlane;
using fuzz::PointSphere;
using predicates::BoundedValue;

template <class Query>
[[nodiscard]] const auto& surface_of(const Query& query) {
  if constexpr (requires { query.line; }) {
    return query.line;
  } else if constexpr (requires { query.plane; }) {
    return query.plane;
  } else {
    return query.sphere;
  }
}

template <class Query>
BoundedValue value_of(const Query& query) {
  return predicates::value(query.point, surface_of(query));
}

template <class Query>
bool is_valid(const Query& query) {
  bool all = true;
  fuzz::for_each_number(query, [&](const auto& x) { all = all && numeric::is_finite(x); });
  if constexpr (requires { query.sphere; }) all = all && !numeric::is_negative(query.sphere.radius);
  return all;
}

/// The share of the bound, where a sign would be told if the value were large enough; a sign that is told is checked too.
template <class Query>
double greatest_share(const Query& query, int& met) {
  const bool valid = is_valid(query);
  const ExactNumber exact = valid ? exact_value(query) : ExactNumber{};
  double greatest = 0;
  for (const Environment& environment : environments) {
    const BoundedValue f = in_mode(environment, value_of<Query>, query);
    if (!valid) {
      // Only certainty would do harm.
      if (f.is_certain()) return std::numeric_limits<double>::infinity();
      continue;
    }
    if (f.is_certain() && static_cast<int>(f.sign()) != sgn(exact.value)) return std::numeric_limits<double>::infinity();
    if (!(f.error < 0x1p960)) continue;
    ++met;
    greatest = std::max(greatest, share_of(f.error, f.value, exact));
  }
  return greatest;
}

template <Real T, class Query>
void require_bounds(const Query& query, int& met) {
  const double share = greatest_share(query, met);
  if (share <= 1) return;
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(share <= 1);
}

template <template <class> class Query>
void check_families(int least) {
  in_both_formats([&]<Real T>() {
    int met = 0;
    each_family_query<Query, T>(6000, [&](const Query<T>& query) { require_bounds<T>(query, met); });
    CHECK(met > least);
  });
}

TEST_CASE("The bounds of implicit forms hold on all families") {
  check_families<PointLine>(8 * 1000);
  check_families<PointPlane>(8 * 1000);
  check_families<PointSphere>(8 * 1000);
}

/// Numbers of every size, so that products underflow, overflow, or fall among the subnormals; f is often nearly zero.
template <template <class> class Query>
void check_all_sizes() {
  in_both_formats([]<Real T>() {
    constexpr std::uint64_t seed = 77;
    CAPTURE(seed);
    fuzz::Random random(seed, "sizes", sizeof(T));
    using Limits = std::numeric_limits<T>;
    int met = 0;
    for (int round = 0; round < 20000; ++round) {
      Query<T> query{};
      const int middle = random.between(Limits::min_exponent - Limits::digits, Limits::max_exponent - 1);
      const int spread = random.one_in(2) ? 2 : 60;
      fuzz::for_each_number(query, [&](T& x) {
        const int size = random.one_in(5) ? -middle : middle;
        x = random.one_in(10)
                ? T(0)
                : random_of_size<T>(random, std::min(size + random.between(-spread, spread), Limits::max_exponent - 1));
      });
      if constexpr (requires { query.sphere; }) query.sphere.radius = std::fabs(query.sphere.radius);
      require_bounds<T>(query, met);
    }
    CHECK(met > 10000);
  });
}

TEST_CASE("The bounds of implicit forms hold for numbers of every size") {
  check_all_sizes<PointLine>();
  check_all_sizes<PointPlane>();
  check_all_sizes<PointSphere>();
}

template <class Query>
void climb_surface(std::string_view name) {
  climb<Query>(name, 60000, [](const Query& query) {
    int met = 0;
    return is_valid(query) ? greatest_share(query, met) : 0.0;
  });
}

TEST_CASE("The bounds of implicit forms hold where a search makes them tight") {
  climb_surface<PointLine<double>>("line");
  climb_surface<PointPlane<double>>("plane");
  climb_surface<PointSphere<double>>("point and sphere");
}

}  // namespace
}  // namespace graze::test
