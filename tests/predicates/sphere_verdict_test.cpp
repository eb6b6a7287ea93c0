// A verdict of the sphere filter is the truth: the kind, which roots, the side of the origin; in every environment of floating
// point.
#include "fuzz/case_text.hpp"
#include "graze/sphere.hpp"
#include "oracle/oracle.hpp"
#include "tests/predicates/exact_terms.hpp"
#include "tests/predicates/near_bounds.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RaySphere;
using predicates::Place;
using predicates::SphereTerms;
using predicates::SphereVerdict;

template <class W, Real T>
SphereVerdict verdict_of(const RaySphere<T>& query) {
  SphereTerms<W> terms = predicates::sphere_terms<W>(query.ray, query.sphere);
  return predicates::verdict(terms, query.ray, query.sphere);
}

struct Spoken {
  int secant = 0, miss = 0, uncertain = 0;
};

/// A verdict of `miss` says nothing of the range and the radius's sign, and an invalid one is no hit either.
template <class W, Real T>
void require_truth(const RaySphere<T>& query, Spoken& spoken) {
  const SphereHit<T> truth = oracle::gmp_oracle().answer(query.ray, query.sphere);
  for (const Environment& environment : environments) {
    const SphereVerdict verdict = in_mode(environment, verdict_of<W, T>, query);
    const bool is_uncertain = verdict.kind == SphereKind::invalid;
    ++(is_uncertain ? spoken.uncertain : verdict.kind == SphereKind::secant ? spoken.secant : spoken.miss);
    const bool is_true = is_uncertain || (verdict.kind == SphereKind::miss && truth.kind == SphereKind::invalid) ||
                         (verdict.kind == truth.kind && verdict.root == truth.root && verdict.origin == truth.origin);
    if (is_true) continue;
    INFO(environment << ": " << fuzz::format_case(fuzz::Case<T>(query)));
    REQUIRE(is_true);
  }
}

TEST_CASE("The sphere filter is never wrong on the families") {
  in_each_filter([]<class W, Real T>() {
    Spoken spoken;
    each_family_query<RaySphere, T>(2000, [&](const RaySphere<T>& query) { require_truth<W>(query, spoken); });
    CHECK(spoken.secant > 1000);
    CHECK(spoken.miss > 1000);
    CHECK(spoken.uncertain > 1000);
  });
}

/// A ray that all but touches a sphere, all but starts on it, or all but ends on it.
template <class W, Real T>
RaySphere<T> near_touch(fuzz::Random& random) {
  RaySphere<T> query{{random_point<T>(random), random_point<T>(random)}, {random_point<T>(random), 1}};
  const auto& [e, d, t_min, t_max] = query.ray;
  const auto& c = query.sphere.center;
  const double t = std::ldexp(1 + static_cast<double>(random.below(64)) / 64, random.between(-3, 3));
  const double x = e.x + t * d.x - c.x, y = e.y + t * d.y - c.y, z = e.z + t * d.z - c.z;
  const double dd = static_cast<double>(d.x) * d.x + static_cast<double>(d.y) * d.y + static_cast<double>(d.z) * d.z;
  const double s = (x * d.x + y * d.y + z * d.z) / dd;
  switch (random.below(3)) {
    case 0:
      // The distance of the center from the line.
      query.sphere.radius = static_cast<T>(std::hypot(x - s * d.x, y - s * d.y, z - s * d.z));
      break;
    case 1:
      query.sphere.radius = static_cast<T>(
          std::hypot(static_cast<double>(c.x) - e.x, static_cast<double>(c.y) - e.y, static_cast<double>(c.z) - e.z));
      break;
    default:
      query.sphere.radius = static_cast<T>(std::hypot(x, y, z));
      aim_range(query.ray, static_cast<T>(t), random);
      break;
  }
  // By about as much as the filter errs.
  constexpr int error = std::same_as<W, float> ? 11 : 40;
  if (!random.one_in(4))
    query.sphere.radius += std::ldexp(query.sphere.radius, -random.between(error, error + 10)) * T(random.sign());
  return query;
}

TEST_CASE("The sphere filter is never wrong where a ray all but touches, or a range all but ends on the sphere") {
  in_each_filter([]<class W, Real T>() {
    constexpr std::uint64_t seed = 32;
    CAPTURE(seed);
    fuzz::Random random(seed, "near touches", sizeof(T));
    Spoken spoken;
    for (int round = 0; round < 30000; ++round) require_truth<W>(near_touch<W, T>(random), spoken);
    CHECK(spoken.secant > 1000);
    CHECK(spoken.miss > 1000);
    CHECK(spoken.uncertain > (std::same_as<T, W> ? 1000 : 0));
  });
}

struct PlaceQuestion {
  double x;
  SphereTerms<double> terms;
};
Place place_of(const PlaceQuestion& question) {
  return predicates::place_of(question.x, question.terms);
}

/// Where x lies against the two roots of the exact quadratic; `uncertain` on one of them.
Place true_place(const ExactSphere& k, double x) {
  // f = A x^2 - 2 B x + C and g = A x - B over one power of two.
  const oracle::gmp::Dyadic at = oracle::gmp::dyadic(x);
  const int unit = std::min(0, at.exponent);
  const mpz_class m = in_units(x, unit);
  const int f_unit = std::min({k.a.unit + 2 * unit, k.b.unit + unit, k.c.unit});
  const auto scaled = [](const mpz_class& value, int from, int to) {
    return mpz_class(value << static_cast<mp_bitcnt_t>(from - to));
  };
  const mpz_class f = scaled(k.a.value * m * m, k.a.unit + 2 * unit, f_unit) -
                      2 * scaled(k.b.value * m, k.b.unit + unit, f_unit) + scaled(k.c.value, k.c.unit, f_unit);
  const int g_unit = std::min(k.a.unit + unit, k.b.unit);
  const mpz_class g = scaled(k.a.value * m, k.a.unit + unit, g_unit) - scaled(k.b.value, k.b.unit, g_unit);
  if (sgn(f) == 0) return Place::uncertain;
  return sgn(f) < 0 ? Place::between : sgn(g) < 0 ? Place::before : Place::after;
}

TEST_CASE("A number is placed rightly against the roots") {
  constexpr std::uint64_t seed = 33;
  CAPTURE(seed);
  fuzz::Random random(seed, "places", 0);
  int placed = 0, uncertain = 0;
  for (int round = 0; round < 30000; ++round) {
    const RaySphere<double> query = near_touch<double, double>(random);
    const ExactSphere exact = exact_terms(query);
    if (sgn(exact.discriminant.value) <= 0) continue;
    const SphereHit<double> hit =
        oracle::gmp_oracle().answer({query.ray.origin, query.ray.direction, -0x1p60, 0x1p60}, query.sphere);
    double x = hit.t[random.below(2)];
    x += x * std::ldexp(random.sign(), -random.between(20, 60));
    if (!numeric::is_ordinary_bound<double>(x)) continue;
    const Place truth = true_place(exact, x);
    for (const Environment& environment : environments) {
      const Place place =
          in_mode(environment, place_of, PlaceQuestion{x, predicates::sphere_terms<double>(query.ray, query.sphere)});
      ++(place == Place::uncertain ? uncertain : placed);
      if (place == Place::uncertain || place == truth) continue;
      CAPTURE(environment, hex(x), static_cast<int>(place), static_cast<int>(truth));
      INFO(fuzz::format_case(fuzz::Case<double>(query)));
      REQUIRE(place == truth);
    }
  }
  CHECK(placed > 10000);
  CHECK(uncertain > 10000);
}

}  // namespace
}  // namespace graze::test
