// The shapes of a leaf against a ray: the filter settles what it can, the exact stage the rest.
#pragma once

#include "exact/order.hpp"
#include "scene/candidate.hpp"
#include "scene/data.hpp"
#include "scene/tally.hpp"

namespace graze::scene {

/// What a query carries along, beside its answer.
template <Real T, class Tally>
struct Query {
  const Data<T>& data;
  const Ray<T>& ray;  ///< valid
  const QueryOptions& options;
  Tally tally;
  bool range_is_plain;  ///< whether the filters take the ray's range

  Query(const Data<T>& d, const Ray<T>& r, const QueryOptions& o, Tally t) noexcept
      : data(d), ray(r), options(o), tally(t), range_is_plain(numeric::is_default_range(r) || numeric::is_ordinary_range<double>(r)) {}

  /// Whether the options let the primitive be seen at all.
  [[nodiscard]] bool sees(std::uint32_t index) const noexcept {
    if (index == options.leave_out) return false;
    return options.mask == ~std::uint32_t(0) || (options.mask & data.mask_of(index)) != 0;
  }
  [[nodiscard]] bool takes(TriangleKind kind, Facing facing) const noexcept {
    if (options.cull_back_faces && facing == Facing::back) return false;
    return !(options.ignore_coplanar && kind == TriangleKind::coplanar);
  }
};

/// Calls hit(lane, enclosure) for each triangle of the block that the ray meets and the query takes, until one returns true;
/// then returns true. `enclosure()` gives an interval about the exact t.
template <Real T, class Tally, class Hit>
[[nodiscard]] inline bool meet(const Query<T, Tally>& query, const TriangleBlock<T>& block, Hit hit) noexcept {
  using predicates::TriangleVerdict;
  for (int i = 0; i < width && block.index[i] != no_primitive; ++i) {
    query.tally.template add<&Statistics::triangle_tests>(1);
    const Triangle<T> triangle = block.triangle(i);
    TriangleVerdict verdict = TriangleVerdict::uncertain;
    predicates::TriangleTerms<double> terms{};
    if (query.range_is_plain) {
      terms = predicates::triangle_terms<double>(query.ray, triangle);
      verdict = predicates::verdict(terms, query.ray);
      query.tally.template add<&Statistics::error_bounds>(1);
    }
    if (verdict == TriangleVerdict::miss) {
      query.tally.template add<&Statistics::filter_misses>(1);
      continue;
    }
    if (!query.sees(block.index[i])) continue;
    if (verdict == TriangleVerdict::face) {
      query.tally.template add<&Statistics::filter_hits>(1);
      if (!query.takes(TriangleKind::face, terms.is_front ? Facing::front : Facing::back)) continue;
      if (hit(i, [&] { return enclose(terms); })) return true;
      continue;
    }
    query.tally.template add<&Statistics::exact_decisions>(1);
    const exact::TriangleDecision decision = exact::decide(query.ray, triangle);
    if (decision.kind == TriangleKind::miss || !query.takes(decision.kind, decision.facing)) continue;
    if (hit(i, [&] { return exact::enclose_first(query.ray, triangle); })) return true;
  }
  return false;
}

/// The same for spheres.
template <Real T, class Tally, class Hit>
[[nodiscard]] inline bool meet(const Query<T, Tally>& query, const SphereBlock<T>& block, Hit hit) noexcept {
  for (int i = 0; i < width && block.index[i] != no_primitive; ++i) {
    query.tally.template add<&Statistics::sphere_tests>(1);
    const Sphere<T> sphere = block.sphere(i);
    predicates::SphereVerdict verdict = predicates::uncertain_sphere;
    predicates::SphereTerms<double> terms{};
    if (query.range_is_plain) {
      terms = predicates::sphere_terms<double>(query.ray, sphere);
      verdict = predicates::verdict(terms, query.ray, sphere);
      query.tally.template add<&Statistics::error_bounds>(1);
    }
    if (verdict.kind == SphereKind::miss) {
      query.tally.template add<&Statistics::filter_misses>(1);
      continue;
    }
    if (!query.sees(block.index[i])) continue;
    if (verdict.kind == SphereKind::secant) {
      query.tally.template add<&Statistics::filter_hits>(1);
      if (hit(i, [&] { return enclose(query.ray, sphere, terms, verdict); })) return true;
      continue;
    }
    query.tally.template add<&Statistics::exact_decisions>(1);
    if (!exact::hits(query.ray, sphere)) continue;
    if (hit(i, [&] { return exact::enclose_first(query.ray, sphere); })) return true;
  }
  return false;
}

}  // namespace graze::scene
