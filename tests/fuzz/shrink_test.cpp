// The shrinker: what it gives fails in the same way, is simpler, and cannot be made simpler one number at a time.
#include "fuzz/shrink/shrink.hpp"

#include <cmath>
#include <limits>

#include "fuzz/case_text.hpp"
#include "fuzz/families/coordinates.hpp"
#include "fuzz/family.hpp"
#include "fuzz/shrink/failure.hpp"
#include "fuzz/subject.hpp"
#include "tests/catch.hpp"

using namespace graze;
using namespace graze::fuzz;

namespace {

/// No number can be dropped, made a small integer, or lose its last bit.
template <Real T>
void check_minimal(const Case<T>& input, const Fails<T>& fails) {
  const std::uint64_t cost = complexity(input);
  Case<T> changed = input;
  const construct::Coordinates<T> all = construct::coordinates(changed);
  for (std::size_t i = 0; i < all.count; ++i) {
    const T old = *all.at[i];
    const auto is_needed = [&](T other) {
      *all.at[i] = other;
      const bool is_simpler_failure = complexity(changed) < cost && fails(changed);
      *all.at[i] = old;
      return !is_simpler_failure;
    };
    for (const int small : {0, 1, -1, 2, 3}) CHECK(is_needed(static_cast<T>(small)));
    if (!std::isfinite(old) || old == 0) continue;
    int exponent = 0;
    std::frexp(old, &exponent);
    for (int bit = exponent - std::numeric_limits<T>::digits; bit < exponent; ++bit) {
      const T unit = std::ldexp(T(1), bit);
      CHECK(is_needed(unit * std::trunc(old / unit)));
    }
    CHECK(is_needed(std::abs(old)));
  }
}

/// Shrinks what the subject gets wrong among the first cases of a family, one case for each way of failing.
template <Real T>
int shrink_family(const Subject& subject, const Family& family, std::vector<Failure>& seen) {
  int found = 0;
  for (std::uint64_t index = 0; index < 60; ++index) {
    const Case<T> input = make<T>(family, 1, index).input;
    const Failure way = failure_of(subject, input);
    if (!way.is_failure() || std::find(seen.begin(), seen.end(), way) != seen.end()) continue;
    seen.push_back(way);
    ++found;
    const Fails<T> fails = [&](const Case<T>& candidate) { return failure_of(subject, candidate) == way; };
    const Shrunk<T> shrunk = shrink(input, fails);
    CAPTURE(std::string(subject.name()), std::string(family.name), index, format_case(input), format_case(shrunk.input));
    CHECK(failure_of(subject, shrunk.input) == way);
    CHECK(complexity(shrunk.input) <= complexity(input));
    CHECK(shrunk.input.index() == input.index());
    CHECK(shrunk.is_minimal);
    check_minimal(shrunk.input, fails);
    CHECK(format_case(shrink(input, fails).input) == format_case(shrunk.input));
    CHECK(format_case(shrink(shrunk.input, fails).input) == format_case(shrunk.input));
  }
  return found;
}

}  // namespace

TEST_CASE("what textbook kernels get wrong shrinks to a case that is minimal and fails in the same way") {
  for (const std::string_view name : {"textbook-naive", "textbook-stable", "cramer", "moller-trumbore"}) {
    const Subject& subject = *find_subject(name);
    std::vector<Failure> seen;
    int found = 0;
    for (const std::string_view family : {"quaternion-tangent", "edge-corner", "coplanar", "range", "implicit", "rounding"}) {
      found += shrink_family<double>(subject, *find_family(family), seen);
    }
    seen.clear();
    found += shrink_family<float>(subject, *find_family("far-small"), seen);
    CAPTURE(std::string(name), found);
    CHECK(found >= 8);
  }
}

TEST_CASE("a known failure shrinks to the example that one would write by hand") {
  // The stable quadratic with sgn(0) = 0 loses the roots of a ray from the center of a sphere.
  const Case<double> input = RaySphere<double>{{{3.25, -1.5, 7.125}, {0.3, 0.7, -1.9}}, {{3.25, -1.5, 7.125}, 2.4}};
  const Subject& subject = *find_subject("textbook-stable");
  const Failure way = failure_of(subject, input);
  REQUIRE(way.is_failure());
  const Fails<double> fails = [&](const Case<double>& candidate) { return failure_of(subject, candidate) == way; };
  const Shrunk<double> shrunk = shrink(input, fails);
  CHECK(complexity(shrunk.input) <= complexity(Case<double>(RaySphere<double>{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}})));
}

TEST_CASE("complexity orders numbers: zero, small integers, few bits, exponents near zero, then what is no number") {
  const auto cost = [](double x) { return complexity(Case<double>(PointLine<double>{{x, 0}, {0, 0, 0}})); };
  CHECK(cost(0.0) == 0);
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> rising{0.0, 1, 2, 3, 5, 11, 0x1.1p+40, 0x1.123p+40, 0x1.123p+900, infinity, std::nan("")};
  for (std::size_t i = 1; i < rising.size(); ++i) CHECK(cost(rising[i - 1]) < cost(rising[i]));
  CHECK(cost(0.5) < cost(0.25));
  CHECK(cost(1) < cost(-1));
  CHECK(cost(-0.0) == 1);
  CHECK(cost(0x1p-1074) > cost(0x1p-1022));
  RaySphere<double> query;
  CHECK(complexity(Case<double>(query)) == 0);
  query.ray.t_max = 1;
  CHECK(complexity(Case<double>(query)) > 0);
}

TEST_CASE("the trials are bounded, and what was reached by then fails still") {
  const Case<double> input = make<double>(*find_family("range"), 1, 3).input;
  const Fails<double> fails = [](const Case<double>& candidate) {
    Case<double> copy = candidate;
    return *construct::coordinates(copy).at[0] != 0;
  };
  REQUIRE(fails(input));
  const Shrunk<double> some = shrink(input, fails, 5), all = shrink(input, fails);
  CHECK(some.trials <= 5);
  CHECK_FALSE(some.is_minimal);
  CHECK(fails(some.input));
  CHECK(all.is_minimal);
  CHECK(complexity(all.input) == complexity(Case<double>(PointLine<double>{{1, 0}, {0, 0, 0}})));
}
