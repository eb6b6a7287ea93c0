#include "fuzz/certify/comparison.hpp"

#include <algorithm>

#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
bool is_hit(const SphereHit<T>& h) {
  return h.kind == SphereKind::tangent || h.kind == SphereKind::secant;
}

template <Real T>
bool is_hit(const TriangleHit<T>& h) {
  return h.kind != TriangleKind::invalid && h.kind != TriangleKind::miss;
}

template <class Hit>
Disagreement compare_hits(const Hit& answer, const Hit& truth) {
  if (answer.status != truth.status) return Disagreement::wrong_kind;
  if (is_hit(answer) != is_hit(truth)) return is_hit(truth) ? Disagreement::lost_hit : Disagreement::false_hit;
  return answer.kind == truth.kind ? Disagreement::none : Disagreement::wrong_kind;
}

template <Real T>
Disagreement compare_decisions(const SphereHit<T>& answer, const SphereHit<T>& truth) {
  const Disagreement d = compare_hits(answer, truth);
  if (d != Disagreement::none || truth.kind == SphereKind::invalid) return d;
  return answer.root == truth.root && answer.origin == truth.origin ? d : Disagreement::wrong_detail;
}

template <Real T>
Disagreement compare_decisions(const TriangleHit<T>& answer, const TriangleHit<T>& truth) {
  const Disagreement d = compare_hits(answer, truth);
  if (d != Disagreement::none || truth.kind == TriangleKind::invalid) return d;
  return answer.facing == truth.facing ? d : Disagreement::wrong_detail;
}

template <Real T>
bool same_numbers(const SphereHit<T>& a, const SphereHit<T>& truth) {
  return std::equal(truth.t, truth.t + truth.count(), a.t, [](T x, T y) { return same_bits(x, y); });
}

template <Real T>
bool same_numbers(const TriangleHit<T>& a, const TriangleHit<T>& truth) {
  if (truth.kind == TriangleKind::miss || truth.kind == TriangleKind::invalid) return true;
  if (!same_bits(a.t, truth.t) || !same_bits(a.t_end, truth.t_end)) return false;
  return truth.is_interval() || (same_bits(a.u, truth.u) && same_bits(a.v, truth.v));
}

using oracle::error_in_ulps;

template <Real T>
double error(const RaySphere<T>& input, const SphereHit<T>& answer, const oracle::Oracle& oracle) {
  const oracle::SphereTruth<T> truth = oracle.truth(input.ray, input.sphere);
  double worst = 0;
  for (int i = 0; i < truth.hit.count(); ++i) worst = std::max(worst, error_in_ulps(truth.t[i], answer.t[i]));
  return worst;
}

template <Real T>
double error(const RayTriangle<T>& input, const TriangleHit<T>& answer, const oracle::Oracle& oracle) {
  const oracle::TriangleTruth<T> truth = oracle.truth(input.ray, input.triangle);
  const double t = error_in_ulps(truth.t, answer.t);
  if (truth.hit.is_interval()) return std::max(t, error_in_ulps(truth.t_end, answer.t_end));
  return std::max({t, error_in_ulps(truth.u, answer.u), error_in_ulps(truth.v, answer.v)});
}

template <class Input, class Hit>
Comparison compare_answers(const Input& input, const Hit& answer, const Hit& truth, const oracle::Oracle& oracle) {
  const Disagreement d = compare_decisions(answer, truth);
  const bool numbers_compare = d == Disagreement::none || d == Disagreement::wrong_detail;
  if (d == Disagreement::wrong_detail && answer.kind == truth.kind) {
    // Roots of unlike choice are not the same numbers.
    if constexpr (requires { truth.root; }) {
      if (answer.root != truth.root) return {d, 0};
    }
  }
  if (!numbers_compare || same_numbers(answer, truth)) return {d, 0};
  return {std::max(d, Disagreement::misrounded), error(input, answer, oracle)};
}

}  // namespace

std::string_view name_of(Disagreement disagreement) {
  switch (disagreement) {
    case Disagreement::none:
      return "agrees";
    case Disagreement::misrounded:
      return "misrounded";
    case Disagreement::wrong_detail:
      return "wrong detail";
    case Disagreement::wrong_kind:
      return "wrong kind";
    case Disagreement::false_hit:
      return "false hit";
    case Disagreement::lost_hit:
      return "lost hit";
    case Disagreement::oracles:
      return "the oracles differ";
  }
  return "unknown";
}

template <Real T>
Comparison compare(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth, const oracle::Oracle& oracle) {
  if (answer.index() != truth.index()) return {Disagreement::wrong_kind, 0};
  if (const auto* query = std::get_if<RaySphere<T>>(&input)) {
    return compare_answers(*query, std::get<SphereHit<T>>(answer), std::get<SphereHit<T>>(truth), oracle);
  }
  if (const auto* query = std::get_if<RayTriangle<T>>(&input)) {
    return compare_answers(*query, std::get<TriangleHit<T>>(answer), std::get<TriangleHit<T>>(truth), oracle);
  }
  return {std::get<Side>(answer) == std::get<Side>(truth) ? Disagreement::none : Disagreement::wrong_kind, 0};
}

template <Real T>
Answer<T> answer_of(const oracle::Oracle& oracle, const Case<T>& input) {
  return std::visit(
      [&](const auto& query) -> Answer<T> {
        if constexpr (requires {
                        query.ray;
                        query.sphere;
                      }) {
          return oracle.answer(query.ray, query.sphere);
        } else if constexpr (requires { query.triangle; }) {
          return oracle.answer(query.ray, query.triangle);
        } else if constexpr (requires { query.line; }) {
          return oracle.side(query.point, query.line);
        } else if constexpr (requires { query.plane; }) {
          return oracle.side(query.point, query.plane);
        } else {
          return oracle.side(query.point, query.sphere);
        }
      },
      input);
}

template Comparison compare(const Case<float>&, const Answer<float>&, const Answer<float>&, const oracle::Oracle&);
template Comparison compare(const Case<double>&, const Answer<double>&, const Answer<double>&, const oracle::Oracle&);
template Answer<float> answer_of(const oracle::Oracle&, const Case<float>&);
template Answer<double> answer_of(const oracle::Oracle&, const Case<double>&);

}  // namespace graze::fuzz
