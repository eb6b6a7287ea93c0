// The greatest share of its bound that a directed search makes a candidate of the rounding stage err by: what it says is
// `error` beside hi + lo, against the exact root or quotient in 1,000 bits.
#include <gmpxx.h>

#include <vector>

#include "fuzz/float_mode.hpp"
#include "rounding/candidate.hpp"
#include "tests/predicates/exact_terms.hpp"
#include "tests/predicates/hill_climb.hpp"

namespace graze::rounding {
namespace {

struct Candidate {
  double hi, lo, error;
};
std::vector<Candidate> candidates;

template <Real T>
bool recorded(double hi, double lo, double error, T& out) noexcept {
  candidates.push_back({hi, lo, error});
  return rounds_certainly(hi, lo, error, out);
}

}  // namespace
}  // namespace graze::rounding

// The stage itself, in this program's own copy, with each of its candidates written down.
#define rounds_certainly recorded
#include "rounding/face.cpp"
#include "rounding/roots.cpp"
#undef rounds_certainly

namespace graze::test {
namespace {

using fuzz::RaySphere;
using fuzz::RayTriangle;
using rounding::Candidate;

constexpr mp_bitcnt_t precision = 1000;

mpf_class real(const ExactNumber& number) {
  mpf_class value(number.value, precision);
  if (number.unit >= 0) return mpf_class(value << static_cast<mp_bitcnt_t>(number.unit));
  return mpf_class(value >> static_cast<mp_bitcnt_t>(-number.unit));
}

double share_of(const Candidate& c, const mpf_class& truth) {
  const mpf_class error = abs(mpf_class(c.hi, precision) + c.lo - truth);
  return mpf_class(error / c.error).get_d();
}

double root_share_of(const RaySphere<double>& query) {
  if (numeric::is_negative(query.sphere.radius)) return 0;
  const auto terms = predicates::sphere_terms<double>(query.ray, query.sphere);
  const ExactSphere exact = exact_terms(query);
  if (!terms.are_bounded || sgn(exact.discriminant.value) <= 0) return 0;
  rounding::candidates.clear();
  (void)rounding::roots(query.ray, query.sphere, terms, {SphereKind::secant, Root::both, OriginSide::outside});
  if (rounding::candidates.empty()) return 0;
  const mpf_class a = real(exact.a), b = real(exact.b), root = sqrt(real(exact.discriminant));
  double greatest = share_of(rounding::candidates[0], mpf_class((b - root) / a));
  if (rounding::candidates.size() > 1) {
    greatest = std::max(greatest, share_of(rounding::candidates[1], mpf_class((b + root) / a)));
  }
  return greatest;
}

double quotient_share_of(const RayTriangle<double>& query) {
  const auto terms = predicates::triangle_terms<double>(query.ray, query.triangle);
  const ExactTriangle exact = exact_terms(query);
  if (!terms.are_bounded || !(terms.whole > terms.error) || sgn(exact.determinant.value) == 0) return 0;
  rounding::candidates.clear();
  (void)rounding::face(query.ray, query.triangle, terms);
  // Asked for together, so all three are there, where the determinant is good enough for any.
  const mpf_class whole = real(exact.determinant);
  const mpf_class truths[] = {mpf_class(real(exact.distance) / whole), mpf_class(real(exact.u) / whole),
                              mpf_class(real(exact.v) / whole)};
  if (!(terms.whole > 2 * rounding::certainty * terms.error)) return 0;
  double greatest = 0;
  for (std::size_t i = 0; i < rounding::candidates.size() && i < 3; ++i) {
    greatest = std::max(greatest, share_of(rounding::candidates[i], truths[i]));
  }
  return greatest;
}

TEST_CASE("Roots in double-double are within their bound where a search makes it tight") {
  climb<RaySphere<double>>("roots in double-double", 300000, root_share_of);
}

TEST_CASE("t, u, v in double-double are within their bound where a search makes it tight") {
  climb<RayTriangle<double>>("quotients in double-double", 300000, quotient_share_of, 0.01);
}

}  // namespace
}  // namespace graze::test
