#include "bench/errors.hpp"

#include <algorithm>
#include <cmath>

#include "fuzz/case_text.hpp"
#include "fuzz/certify/comparison.hpp"
#include "fuzz/same_bits.hpp"

namespace graze::bench {
namespace {

template <Real T>
void compare_numbers(const SphereHit<T>& answer, const oracle::SphereTruth<T>& truth, const fuzz::Deviations&, Judgment& out) {
  T roots[2] = {answer.t[0], answer.t[1]};
  if (answer.count() == 2 && roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  for (int i = 0; i < answer.count(); ++i) {
    // A tangent's one root is what both values of a secant in its place are held against.
    const int twin = std::min(i, truth.hit.count() - 1);
    out.t_errors.push_back(oracle::error_in_ulps(truth.t[twin], roots[i]));
    out.t_is_correct.push_back(fuzz::same_bits(roots[i], truth.hit.t[twin]));
  }
}

template <Real T>
void compare_numbers(const TriangleHit<T>& answer, const oracle::TriangleTruth<T>& truth, const fuzz::Deviations& allowed,
                     Judgment& out) {
  out.t_errors.push_back(oracle::error_in_ulps(truth.t, answer.t));
  out.t_is_correct.push_back(fuzz::same_bits(answer.t, truth.hit.t));
  if (answer.is_interval() && truth.hit.is_interval()) {
    out.t_errors.push_back(oracle::error_in_ulps(truth.t_end, answer.t_end));
    out.t_is_correct.push_back(fuzz::same_bits(answer.t_end, truth.hit.t_end));
  } else if (!truth.hit.is_interval() && !allowed.set.has(fuzz::Deviation::no_coordinates)) {
    out.uv_errors.push_back(oracle::error_in_ulps(truth.u, answer.u));
    out.uv_errors.push_back(oracle::error_in_ulps(truth.v, answer.v));
  }
}

template <class Query>
using NumberOf = std::remove_cvref_t<decltype(Query{}.ray.t_min)>;

template <Real T>
SphereHit<T> with_decision(const SphereHit<T>& truth, bool is_hit) {
  SphereHit<T> hit;
  hit.origin = truth.origin;
  hit.kind = is_hit ? SphereKind::secant : SphereKind::miss;
  return hit;
}
template <Real T>
TriangleHit<T> with_decision(const TriangleHit<T>& truth, bool is_hit) {
  TriangleHit<T> hit;
  hit.facing = truth.facing;
  hit.kind = is_hit ? TriangleKind::face : TriangleKind::miss;
  return hit;
}

void finish(Errors& out, std::vector<double>& errors) {
  out.values = errors.size();
  if (errors.empty()) return;
  out.median = quantile(errors, 0.5);
  out.p999 = quantile(errors, 0.999);
  out.max = quantile(errors, 1);
}

}  // namespace

double quantile(std::vector<double>& values, double q) {
  const auto n = static_cast<double>(values.size());
  const auto rank = static_cast<std::ptrdiff_t>(std::clamp(std::ceil(q * n), 1.0, n)) - 1;
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

double Judgment::worst() const {
  double worst = -1;
  for (const double e : t_errors) worst = std::max(worst, e);
  for (const double e : uv_errors) worst = std::max(worst, e);
  return worst;
}

template <class Query>
std::vector<TruthOf<Query>> truths_of(std::span<const Query> queries) {
  std::vector<TruthOf<Query>> out;
  out.reserve(queries.size());
  for (const Query& query : queries) {
    if constexpr (requires { query.sphere; }) {
      out.push_back(oracle::gmp_oracle().truth(query.ray, query.sphere));
    } else {
      out.push_back(oracle::gmp_oracle().truth(query.ray, query.triangle));
    }
  }
  return out;
}

template <class Query>
Judgment judge(const Query& query, const HitOf<Query>& answer, const TruthOf<Query>& truth, const fuzz::Deviations& allowed) {
  using T = NumberOf<Query>;
  // The truth may not be asked about numbers here: any error is allowed for, they are measured below.
  fuzz::Deviations decisions = allowed;
  decisions.t_ulps = decisions.uv_ulps = std::numeric_limits<double>::infinity();
  const fuzz::Comparison comparison = fuzz::compare<T>(fuzz::Case<T>(query), fuzz::Answer<T>(answer),
                                                       fuzz::Answer<T>(truth.hit), oracle::gmp_oracle(), decisions);
  Judgment out;
  out.is_wrong = comparison.disagreement > fuzz::Disagreement::misrounded;
  if (!out.is_wrong && comparison.has_numbers) compare_numbers(answer, truth, allowed, out);
  return out;
}

template <class Query>
Errors errors_of(std::span<const Query> queries, std::span<const TruthOf<Query>> truths, std::span<const HitOf<Query>> answers,
                 const fuzz::Deviations& allowed) {
  using T = NumberOf<Query>;
  Errors out;
  std::vector<double> errors;
  double worst = -1;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const Judgment j = judge(queries[i], answers[i], truths[i], allowed);
    ++out.queries;
    out.hits += fuzz::is_hit(truths[i].hit) ? 1 : 0;
    out.wrong += j.is_wrong ? 1 : 0;
    for (std::size_t k = 0; k < j.t_errors.size(); ++k) {
      errors.push_back(j.t_errors[k]);
      out.correct += j.t_is_correct[k] ? 1 : 0;
      if (j.t_errors[k] > worst) {
        worst = j.t_errors[k];
        out.worst_case = fuzz::format_case(fuzz::Case<T>(queries[i]));
      }
    }
  }
  finish(out, errors);
  return out;
}

template <class Query>
Errors errors_of(std::span<const Query> queries, std::span<const TruthOf<Query>> truths, const std::vector<bool>& decisions,
                 const fuzz::Deviations& allowed) {
  Errors out;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const HitOf<Query>& truth = truths[i].hit;
    const bool truly_hits = fuzz::is_hit(truth);
    ++out.queries;
    out.hits += truly_hits ? 1 : 0;
    if (decisions[i] == truly_hits) continue;
    // The whole answer that the decision stands for, right in all else.
    out.wrong += judge(queries[i], with_decision(truth, decisions[i]), truths[i], allowed).is_wrong ? 1 : 0;
  }
  return out;
}

#define GRAZE_FOR(Query)                                                                                                   \
  template std::vector<TruthOf<Query>> truths_of<Query>(std::span<const Query>);                                           \
  template Judgment judge<Query>(const Query&, const HitOf<Query>&, const TruthOf<Query>&, const fuzz::Deviations&);       \
  template Errors errors_of<Query>(std::span<const Query>, std::span<const TruthOf<Query>>, std::span<const HitOf<Query>>, \
                                   const fuzz::Deviations&);                                                               \
  template Errors errors_of<Query>(std::span<const Query>, std::span<const TruthOf<Query>>, const std::vector<bool>&,      \
                                   const fuzz::Deviations&);
GRAZE_FOR(fuzz::RaySphere<float>)
GRAZE_FOR(fuzz::RaySphere<double>)
GRAZE_FOR(fuzz::RayTriangle<float>)
GRAZE_FOR(fuzz::RayTriangle<double>)
#undef GRAZE_FOR

}  // namespace graze::bench
