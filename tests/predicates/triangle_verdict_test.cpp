// A verdict of the triangle filter is the truth, in every environment of floating point.
#include "fuzz/case_text.hpp"
#include "graze/predicates/triangle_filter.hpp"
#include "oracle/oracle.hpp"
#include "tests/predicates/near_bounds.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RayTriangle;
using predicates::TriangleVerdict;

template <class W, Real T>
TriangleVerdict verdict_of(const RayTriangle<T>& query) {
  return predicates::verdict(predicates::triangle_terms<W>(query.ray, query.triangle), query.ray);
}

/// How often the filter spoke, and how often it left a case to the exact stage.
struct Spoken {
  int face = 0, miss = 0, uncertain = 0;
};

/// A verdict of `miss` says nothing of the range, and an invalid one is no hit either.
[[nodiscard]] bool is_hit_of(TriangleKind kind) {
  return kind != TriangleKind::miss && kind != TriangleKind::invalid;
}

template <class W, Real T>
void require_truth(const RayTriangle<T>& query, Spoken& spoken) {
  const TriangleHit<T> truth = oracle::gmp_oracle().answer(query.ray, query.triangle);
  for (const Environment& environment : environments) {
    const TriangleVerdict verdict = in_mode(environment, verdict_of<W, T>, query);
    ++(verdict == TriangleVerdict::face ? spoken.face : verdict == TriangleVerdict::miss ? spoken.miss : spoken.uncertain);
    const bool is_true = verdict == TriangleVerdict::uncertain ||
                         (verdict == TriangleVerdict::face ? truth.kind == TriangleKind::face : !is_hit_of(truth.kind));
    if (is_true) continue;
    INFO(environment << ": " << fuzz::format_case(fuzz::Case<T>(query)));
    REQUIRE(is_true);
  }
}

TEST_CASE("The triangle filter is never wrong on the families") {
  in_each_filter([]<class W, Real T>() {
    Spoken spoken;
    each_family_query<RayTriangle, T>(2000, [&](const RayTriangle<T>& query) { require_truth<W>(query, spoken); });
    CHECK(spoken.face > 1000);
    CHECK(spoken.miss > 1000);
    CHECK(spoken.uncertain > 1000);
  });
}

TEST_CASE("The triangle filter is never wrong where a ray is aimed at an edge") {
  in_each_filter([]<class W, Real T>() {
    constexpr std::uint64_t seed = 31;
    CAPTURE(seed);
    fuzz::Random random(seed, "near misses", sizeof(T));
    Spoken spoken;
    for (int round = 0; round < 30000; ++round) {
      RayTriangle<T> query{};
      for (Vec3<T>* v : {&query.ray.origin, &query.triangle.a, &query.triangle.b, &query.triangle.c})
        *v = random_point<T>(random);
      // Toward a point on an edge, in working precision: off it by about as much as the filter errs.
      const auto& [a, b, c] = query.triangle;
      const T share = T(random.below(1024)) / T(1024);
      const Vec3<T>&p = random.one_in(2) ? a : b, &e = query.ray.origin;
      query.ray.direction = {p.x + share * (c.x - p.x) - e.x, p.y + share * (c.y - p.y) - e.y, p.z + share * (c.z - p.z) - e.z};
      if (random.one_in(3)) aim_range(query.ray, T(1), random);
      if (random.one_in(6)) query.ray.direction = random_point<T>(random);
      require_truth<W>(query, spoken);
    }
    CHECK(spoken.face > 1000);
    CHECK(spoken.miss > 1000);
    CHECK(spoken.uncertain > (std::same_as<T, W> ? 1000 : 0));
  });
}

}  // namespace
}  // namespace graze::test
