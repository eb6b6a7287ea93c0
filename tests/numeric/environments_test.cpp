// The environments that other tests call the kernel in are what they say, and end with their scope.
#include <limits>

#include "tests/catch.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

struct Operands {
  double a, b;
};
double sum(const Operands& x) {
  return x.a + x.b;
}
double product(const Operands& x) {
  return x.a * x.b;
}

TEST_CASE("A rounding mode rounds as it says") {
  for (const bool flushes : {false, true}) {
    CAPTURE(flushes);
    const Operands above{1, 0x1p-60}, below{-1, -0x1p-60};
    CHECK(in_mode({FloatMode::nearest, flushes}, sum, above) == 1);
    CHECK(in_mode({FloatMode::upward, flushes}, sum, above) > 1);
    CHECK(in_mode({FloatMode::upward, flushes}, sum, below) == -1);
    CHECK(in_mode({FloatMode::downward, flushes}, sum, above) == 1);
    CHECK(in_mode({FloatMode::downward, flushes}, sum, below) < -1);
    CHECK(in_mode({FloatMode::toward_zero, flushes}, sum, Operands{1, -0x1p-60}) < 1);
    CHECK(in_mode({FloatMode::toward_zero, flushes}, sum, above) == 1);
  }
}

#if defined(__SSE2__)
TEST_CASE("Flushing reads subnormal numbers as zero and answers zero for them") {
  const double least = std::numeric_limits<double>::denorm_min(), small = std::numeric_limits<double>::min();
  for (const FloatMode rounding : rounding_modes) {
    CHECK(in_mode({rounding, false}, product, Operands{least, 0x1p60}) > 0);
    CHECK(in_mode({rounding, true}, product, Operands{least, 0x1p60}) == 0);
    CHECK(in_mode({rounding, false}, product, Operands{small, 0.5}) > 0);
    CHECK(in_mode({rounding, true}, product, Operands{small, 0.5}) == 0);
  }
}

TEST_CASE("SSE may round otherwise than the rest") {
  const SseRoundingScope scope(_MM_ROUND_UP);
  Operands operands{1, 0x1p-60};
  asm volatile("" : "+m"(operands));
  CHECK(sum(operands) > 1);
}
#endif

TEST_CASE("An environment ends with its scope") {
  const FloatControl before = float_control();
  for (const Environment& environment : environments) {
    {
      const EnvironmentScope scope(environment);
      const bool is_default = environment == Environment{};
      CHECK((float_control() == before) == is_default);
    }
    CHECK(float_control() == before);
  }
}

}  // namespace
}  // namespace graze::test
