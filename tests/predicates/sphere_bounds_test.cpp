// A, B, C and both forms of the discriminant are within what the sphere filter says of them, in every environment of floating
// point.
#include "graze/sphere.hpp"
#include "tests/predicates/exact_terms.hpp"
#include "tests/predicates/hill_climb.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"
#include "tests/support/in_mode.hpp"

namespace graze::test {
namespace {

using fuzz::RaySphere;
using predicates::SphereTerms;

/// In float the second is the first.
template <class W>
struct BothForms {
  SphereTerms<W> first, refined;
};

template <class W, Real T>
BothForms<W> terms_of(const RaySphere<T>& query) {
  BothForms<W> forms;
  forms.first = forms.refined = predicates::sphere_terms<W>(query.ray, query.sphere);
  if constexpr (std::same_as<W, double>) predicates::refine_discriminant(forms.refined, query.ray, query.sphere);
  return forms;
}

/// A is rounded 3 times, B's monomials 4 times; the discriminant's bound, place_of and the rounding stage rest on it.
template <class W>
double a_error(const SphereTerms<W>& t) {
  return 3.001 * numeric::unit_of<W> * t.a;
}
template <class W>
double b_error(const SphereTerms<W>& t) {
  return 4.001 * numeric::unit_of<W> * std::sqrt(static_cast<double>(t.a)) * std::sqrt(static_cast<double>(t.c_size));
}

template <class W, Real T>
double greatest_share(const RaySphere<T>& query, int& met) {
  bool is_valid = numeric::is_finite(query.ray.origin) && numeric::is_finite(query.ray.direction);
  is_valid = is_valid && numeric::is_finite(query.sphere.center) && numeric::is_finite(query.sphere.radius);
  if (!is_valid || numeric::is_negative(query.sphere.radius)) return 0;
  const ExactSphere exact = exact_terms(query);
  double greatest = 0;
  for (const Environment& environment : environments) {
    const auto [t, refined] = in_mode(environment, terms_of<W, T>, query);
    if (!t.are_bounded) continue;
    ++met;
    greatest = std::max({greatest, share_of(a_error(t), t.a, exact.a), share_of(b_error(t), t.b, exact.b),
                         share_of(t.c_error, t.c, exact.c), share_of(t.discriminant_error, t.discriminant, exact.discriminant),
                         share_of(refined.discriminant_error, refined.discriminant, exact.discriminant)});
  }
  return greatest;
}

template <class W, Real T>
void require_bounds(const RaySphere<T>& query, int& met) {
  const double share = greatest_share<W>(query, met);
  if (share <= 1) return;
  INFO(fuzz::format_case(fuzz::Case<T>(query)));
  REQUIRE(share <= 1);
}

TEST_CASE("The sphere filter's bounds hold on all families") {
  in_each_filter([]<class W, Real T>() {
    int met = 0;
    each_family_query<RaySphere, T>(2000, [&](const RaySphere<T>& query) { require_bounds<W>(query, met); });
    CHECK(met > 8 * 10000);
  });
}

TEST_CASE("The sphere filter's bounds hold at the ends of what it takes") {
  in_each_filter([]<class W, Real T>() {
    constexpr std::uint64_t seed = 201;
    CAPTURE(seed);
    fuzz::Random random(seed, "sphere ends", sizeof(T));
    const int least = std::same_as<W, float> ? -19 : std::same_as<T, float> ? -39 : -199;
    const int greatest = std::same_as<W, float> ? 27 : std::same_as<T, float> ? 123 : 197;
    const auto random_size = [&] { return random.one_in(2) ? least : greatest; };
    int met = 0;
    for (int round = 0; round < 20000; ++round) {
      RaySphere<T> query{};
      const int positions = random_size(), directions = random_size();
      const auto set = [&](T& x, int size) {
        x = random_of_size<T>(random, random.one_in(4) ? size - random.between(50, 900) : size);
      };
      for (T* x : {&query.ray.direction.x, &query.ray.direction.y, &query.ray.direction.z}) set(*x, directions);
      for (Vec3<T>* v : {&query.ray.origin, &query.sphere.center}) {
        for (T* x : {&v->x, &v->y, &v->z}) set(*x, positions);
      }
      set(query.sphere.radius, positions);
      query.sphere.radius = std::fabs(query.sphere.radius);
      require_bounds<W>(query, met);
    }
    CHECK(met > 8 * 5000);
  });
}

/// The greatest share of one term over the rounding modes.
template <class Term>
void climb_term(std::string_view name, Term term) {
  climb<RaySphere<double>>(name, 60000, [&](const RaySphere<double>& query) {
    if (numeric::is_negative(query.sphere.radius)) return 0.0;
    const ExactSphere exact = exact_terms(query);
    double greatest = 0;
    for (const FloatMode mode : rounding_modes) {
      const BothForms<double> forms = in_mode({mode, false}, terms_of<double, double>, query);
      if (forms.first.are_bounded) greatest = std::max(greatest, term(forms, exact));
    }
    return greatest;
  });
}

TEST_CASE("The sphere filter's bounds hold where a search makes them tight") {
  climb_term("sphere A", [](const BothForms<double>& t, const ExactSphere& exact) {
    return share_of(a_error(t.first), t.first.a, exact.a);
  });
  climb_term("sphere B", [](const BothForms<double>& t, const ExactSphere& exact) {
    return share_of(b_error(t.first), t.first.b, exact.b);
  });
  climb_term("sphere C", [](const BothForms<double>& t, const ExactSphere& exact) {
    return share_of(t.first.c_error, t.first.c, exact.c);
  });
  climb_term("sphere discriminant", [](const BothForms<double>& t, const ExactSphere& exact) {
    return share_of(t.first.discriminant_error, t.first.discriminant, exact.discriminant);
  });
  climb_term("sphere discriminant, refined", [](const BothForms<double>& t, const ExactSphere& exact) {
    return share_of(t.refined.discriminant_error, t.refined.discriminant, exact.discriminant);
  });
}

}  // namespace
}  // namespace graze::test
