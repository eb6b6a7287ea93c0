#include "fuzz/certify/comparison.hpp"

#include <algorithm>
#include <utility>

#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

using oracle::error_in_ulps;

/// A comparison in the making: each difference is the subject's declared deviation or a disagreement.
struct Judgment {
  const Deviations& declared;
  Comparison result;

  void disagree(Disagreement d) { result.disagreement = std::max(result.disagreement, d); }

  /// Whether the difference is declared, and then noted.
  bool allows(Deviation deviation) {
    if (!declared.set.has(deviation)) return false;
    result.allowed.add(deviation);
    return true;
  }

  /// A difference that one deviation may excuse.
  void differs(Disagreement d, Deviation excuse) {
    if (!allows(excuse)) disagree(d);
  }

  template <Real T>
  void compare_number(const oracle::Exact& exact, T truth, T answer, double limit) {
    result.has_numbers = true;
    if (same_bits(truth, answer)) return;
    const double error = error_in_ulps(exact, answer);
    result.error_ulps = std::max(result.error_ulps, error);
    // Of the numbers within half a unit only one is the rounded one: without a wider limit it alone will do.
    if (limit > 0.5 && error <= limit) {
      result.allowed.add(Deviation::inexact_numbers);
    } else {
      disagree(Disagreement::misrounded);
    }
  }
};

/// True where there is nothing more to compare: one of them is invalid, or only one is a hit.
template <class Hit>
bool settle_hit(const Hit& answer, const Hit& truth, Judgment& judgment) {
  if (truth.status != Status::ok) {
    if (answer.status != truth.status) judgment.differs(Disagreement::invalid_handling, Deviation::invalid_unhandled);
    return true;
  }
  if (is_hit(answer) != is_hit(truth)) {
    judgment.disagree(is_hit(truth) ? Disagreement::lost_hit : Disagreement::false_hit);
    return true;
  }
  if (answer.status != truth.status) {
    judgment.disagree(Disagreement::wrong_kind);
    return true;
  }
  return false;
}

template <Real T>
void judge_numbers(const RaySphere<T>& input, const SphereHit<T>& answer, const SphereHit<T>& truth,
                   const oracle::Oracle& oracle, Judgment& judgment) {
  judgment.result.has_numbers = true;
  T roots[2] = {answer.t[0], answer.t[1]};
  if (answer.count() == 2 && roots[0] > roots[1]) {
    judgment.disagree(Disagreement::wrong_order);
    std::swap(roots[0], roots[1]);
  }
  // A tangent's one root is what both values of a secant in its place are held against.
  const auto twin = [&](int i) { return std::min(i, truth.count() - 1); };
  bool same = true;
  for (int i = 0; i < answer.count(); ++i) same = same && same_bits(roots[i], truth.t[twin(i)]);
  if (same) return;
  const oracle::SphereTruth<T> exact = oracle.truth(input.ray, input.sphere);
  for (int i = 0; i < answer.count(); ++i) {
    judgment.compare_number(exact.t[twin(i)], truth.t[twin(i)], roots[i], judgment.declared.t_ulps);
  }
}

template <Real T>
void judge(const RaySphere<T>& input, const SphereHit<T>& answer, const SphereHit<T>& truth, const oracle::Oracle& oracle,
           Judgment& judgment) {
  if (settle_hit(answer, truth, judgment)) return;
  if (answer.origin != truth.origin) judgment.differs(Disagreement::wrong_detail, Deviation::no_origin);
  if (!is_hit(truth)) return;
  if (answer.kind != truth.kind && !judgment.allows(Deviation::hit_or_miss)) {
    if (truth.kind == SphereKind::secant || !judgment.allows(Deviation::tangents_are_secants)) {
      return judgment.disagree(Disagreement::wrong_kind);
    }
  }
  const bool may_have_two = truth.kind == SphereKind::tangent && answer.kind == SphereKind::secant;
  if (answer.count() != truth.count() && !may_have_two) {
    if (answer.count() > truth.count() || !judgment.allows(Deviation::nearest_root)) {
      return judgment.disagree(Disagreement::wrong_kind);
    }
  } else if (answer.root != truth.root && !may_have_two && !judgment.allows(Deviation::no_root)) {
    // Roots of unlike choice are not the same numbers.
    return judgment.disagree(Disagreement::wrong_detail);
  }
  judge_numbers(input, answer, truth, oracle, judgment);
}

/// The part of the triangle that is hit; false where the numbers do not compare.
template <Real T>
bool judge_feature(const TriangleHit<T>& answer, const TriangleHit<T>& truth, Judgment& judgment) {
  if (answer.kind == truth.kind || judgment.allows(Deviation::hit_or_miss)) return true;
  const bool is_finer = !truth.is_interval() && answer.kind == TriangleKind::face;
  if (is_finer && judgment.allows(Deviation::edges_are_faces)) return true;
  judgment.disagree(Disagreement::wrong_kind);
  return false;
}

template <Real T>
void judge_numbers(const RayTriangle<T>& input, const TriangleHit<T>& answer, const TriangleHit<T>& truth,
                   const oracle::Oracle& oracle, Judgment& judgment) {
  judgment.result.has_numbers = true;
  const bool both_points = !truth.is_interval() && !answer.is_interval();
  const bool both_intervals = truth.is_interval() && answer.is_interval();
  const bool same_uv = !both_points || (same_bits(answer.u, truth.u) && same_bits(answer.v, truth.v));
  const bool has_uv = both_points && (same_uv || !judgment.allows(Deviation::no_coordinates));
  if (same_bits(answer.t, truth.t) && (!both_intervals || same_bits(answer.t_end, truth.t_end)) && (same_uv || !has_uv)) return;
  const oracle::TriangleTruth<T> exact = oracle.truth(input.ray, input.triangle);
  judgment.compare_number(exact.t, truth.t, answer.t, judgment.declared.t_ulps);
  if (both_intervals) judgment.compare_number(exact.t_end, truth.t_end, answer.t_end, judgment.declared.t_ulps);
  if (has_uv) {
    judgment.compare_number(exact.u, truth.u, answer.u, judgment.declared.uv_ulps);
    judgment.compare_number(exact.v, truth.v, answer.v, judgment.declared.uv_ulps);
  }
}

/// A miss where the subject declares one in place of an interval.
template <Real T>
bool is_declared_miss(const TriangleHit<T>& answer, const TriangleHit<T>& truth, Judgment& judgment) {
  if (answer.status != Status::ok || answer.kind != TriangleKind::miss) return false;
  return (truth.kind == TriangleKind::coplanar && judgment.allows(Deviation::coplanar_is_miss)) ||
         (truth.kind == TriangleKind::degenerate && judgment.allows(Deviation::degenerate_is_miss));
}

template <Real T>
void judge(const RayTriangle<T>& input, const TriangleHit<T>& answer, const TriangleHit<T>& truth, const oracle::Oracle& oracle,
           Judgment& judgment) {
  if (!is_declared_miss(answer, truth, judgment) && settle_hit(answer, truth, judgment)) return;
  if (answer.facing != truth.facing) judgment.differs(Disagreement::wrong_detail, Deviation::no_facing);
  if (!is_hit(answer) || !judge_feature(answer, truth, judgment)) return;
  judge_numbers(input, answer, truth, oracle, judgment);
}

void judge(const Side& answer, const Side& truth, Judgment& judgment) {
  if (truth.status != Status::ok) {
    if (answer.status != truth.status) judgment.differs(Disagreement::invalid_handling, Deviation::invalid_unhandled);
  } else if (answer.status != Status::ok || answer.sign != truth.sign) {
    judgment.disagree(Disagreement::wrong_kind);
  }
}

}  // namespace

std::string_view name_of(Disagreement disagreement) {
  switch (disagreement) {
    case Disagreement::none:
      return "agrees";
    case Disagreement::invalid_handling:
      return "invalid handling";
    case Disagreement::misrounded:
      return "misrounded";
    case Disagreement::wrong_detail:
      return "wrong detail";
    case Disagreement::wrong_order:
      return "wrong order";
    case Disagreement::wrong_kind:
      return "wrong kind";
    case Disagreement::false_hit:
      return "false hit";
    case Disagreement::lost_hit:
      return "lost hit";
    case Disagreement::failed:
      return "failed";
    case Disagreement::oracles:
      return "the oracles differ";
  }
  return "unknown";
}

template <Real T>
Comparison compare(const Case<T>& input, const Answer<T>& answer, const Answer<T>& truth, const oracle::Oracle& oracle,
                   const Deviations& declared) {
  Judgment judgment{declared, {}};
  if (answer.index() != truth.index()) {
    judgment.disagree(Disagreement::wrong_kind);
  } else if (const auto* ray_sphere = std::get_if<RaySphere<T>>(&input)) {
    judge(*ray_sphere, std::get<SphereHit<T>>(answer), std::get<SphereHit<T>>(truth), oracle, judgment);
  } else if (const auto* ray_triangle = std::get_if<RayTriangle<T>>(&input)) {
    judge(*ray_triangle, std::get<TriangleHit<T>>(answer), std::get<TriangleHit<T>>(truth), oracle, judgment);
  } else {
    judge(std::get<Side>(answer), std::get<Side>(truth), judgment);
  }
  return judgment.result;
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

template Comparison compare(const Case<float>&, const Answer<float>&, const Answer<float>&, const oracle::Oracle&,
                            const Deviations&);
template Comparison compare(const Case<double>&, const Answer<double>&, const Answer<double>&, const oracle::Oracle&,
                            const Deviations&);
template Answer<float> answer_of(const oracle::Oracle&, const Case<float>&);
template Answer<double> answer_of(const oracle::Oracle&, const Case<double>&);

}  // namespace graze::fuzz
