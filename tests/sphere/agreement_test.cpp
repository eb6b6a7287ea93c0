// Ray and sphere against the oracle on all families: in every environment, around every answer, from two threads.
#include "tests/support/agreement.hpp"

#include <type_traits>

#include "graze/sphere.hpp"
#include "tests/support/around.hpp"
#include "tests/support/threads.hpp"
#include "tests/support/tiers.hpp"

namespace graze::test {
namespace {

template <Real T>
constexpr bool is_callable_anywhere = noexcept(intersect(Ray<T>{}, Sphere<T>{})) && noexcept(hits(Ray<T>{}, Sphere<T>{})) &&
                                      std::is_trivially_copyable_v<SphereHit<T>>;
static_assert(is_callable_anywhere<float> && is_callable_anywhere<double>);

TEST_CASE("Ray and sphere: the oracle's bits on all families") {
  require_agreement_on_families<fuzz::RaySphere>(4000, 30000);
}

TEST_CASE("Ray and sphere: the same bits in every environment, which is left as it was") {
  require_agreement_on_families_in_all_environments<fuzz::RaySphere>(2000, 15000);
}

TEST_CASE("Ray and sphere: the same bits with the rounding mode set for SSE alone") {
  require_agreement_with_sse_rounding<fuzz::RaySphere>(300);
}

TEST_CASE("Ray and sphere: numbers that fill the widths of the exact stage") {
  require_agreement_at_tier_ends<fuzz::RaySphere>(3000);
}

TEST_CASE("Ray and sphere: ranges that end at the answer, or one ulp off it") {
  require_agreement_around_family_answers<fuzz::RaySphere>(600, 20000);
}

TEST_CASE("Ray and sphere: two threads answer as one") {
  require_agreement_between_threads<fuzz::RaySphere, float>(500);
  require_agreement_between_threads<fuzz::RaySphere, double>(500);
}

}  // namespace
}  // namespace graze::test
