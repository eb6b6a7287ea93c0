// Ray and triangle against the oracle on all families: in every environment, around every answer, from two threads.
#include "tests/support/agreement.hpp"

#include <type_traits>

#include "graze/triangle.hpp"
#include "tests/support/around.hpp"
#include "tests/support/threads.hpp"
#include "tests/support/tiers.hpp"

namespace graze::test {
namespace {

template <Real T>
constexpr bool is_callable_anywhere = noexcept(intersect(Ray<T>{}, Triangle<T>{})) && noexcept(hits(Ray<T>{}, Triangle<T>{})) &&
                                      std::is_trivially_copyable_v<TriangleHit<T>>;
static_assert(is_callable_anywhere<float> && is_callable_anywhere<double>);

TEST_CASE("Ray and triangle: the oracle's bits on all families") {
  require_agreement_on_families<fuzz::RayTriangle>(4000, 30000);
}

TEST_CASE("Ray and triangle: the same bits in every environment, which is left as it was") {
  require_agreement_on_families_in_all_environments<fuzz::RayTriangle>(2000, 15000);
}

TEST_CASE("Ray and triangle: the same bits with the rounding mode set for SSE alone") {
  require_agreement_with_sse_rounding<fuzz::RayTriangle>(300);
}

TEST_CASE("Ray and triangle: numbers that fill the widths of the exact stage") {
  require_agreement_at_tier_ends<fuzz::RayTriangle>(3000);
}

TEST_CASE("Ray and triangle: ranges that end at the answer, or one ulp off it") {
  require_agreement_around_family_answers<fuzz::RayTriangle>(600, 20000);
}

TEST_CASE("Ray and triangle: two threads answer as one") {
  require_agreement_between_threads<fuzz::RayTriangle, float>(500);
  require_agreement_between_threads<fuzz::RayTriangle, double>(500);
}

}  // namespace
}  // namespace graze::test
