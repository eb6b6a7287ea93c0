// A query on its way: what is asked, and the best hit so far.
#pragma once

#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "numeric/integer.hpp"
#include "rounding/quotients.hpp"
#include "scene/box_ray.hpp"
#include "scene/data.hpp"
#include "scene/enclose.hpp"
#include "scene/tally.hpp"

namespace graze::scene {

/// What a query carries along, beside its answer.
template <Real T, class Tally>
struct Query {
  const Data<T>& data;
  const Ray<T>& ray;
  const QueryOptions& options;
  Tally tally;

  /// Whether every primitive is seen and taken, in one leaf alone.
  [[nodiscard]] bool takes_all() const noexcept {
    const QueryOptions& o = options;
    return data.listings.empty() && !o.ignore_coplanar && !o.cull_back_faces && o.leave_out == no_primitive &&
           o.mask == ~std::uint32_t(0);
  }
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

/// A hit: which primitive, where it lies, and an interval that holds its exact first value.
struct Candidate {
  Shape shape = Shape::none;
  bool is_face = false;     ///< a triangle's, of which the filter is sure
  bool is_rough = false;    ///< only the filter in float has been asked: `t` is no better
  bool is_integer = false;  ///< `whole` and `distance` are exact
  std::uint8_t lane = 0;
  std::uint32_t block = 0;
  std::uint32_t index = no_primitive;
  Enclosure t{};
  double whole = 0, distance = 0;  ///< a triangle's determinants, where is_integer
  rounding::FaceBounds bounds{};   ///< where is_face
};

/// Calls f with the candidate's shape.
template <Real T, class F>
inline auto with_shape(const Data<T>& data, const Candidate& c, F f) noexcept {
  return c.shape == Shape::triangle ? f(data.triangles[c.block].triangle(c.lane)) : f(data.spheres[c.block].sphere(c.lane));
}

/// The sign of one's distance / whole minus the other's, which are exact: integers of at most 53 bits in their common unit.
[[nodiscard]] inline int compare_quotients(const Candidate& one, const Candidate& other) noexcept {
  using namespace numeric;
  const Dyadic n1 = dyadic(one.distance), n2 = dyadic(other.distance), d1 = dyadic(one.whole), d2 = dyadic(other.whole);
  Extent n, d;
  n.include(n1);
  n.include(n2);
  d.include(d1);
  d.include(d2);
  return numeric::compare(integer<1>(n1, n.low) * integer<1>(d2, d.low), integer<1>(n2, n.low) * integer<1>(d1, d.low));
}

/// With `t` as good as double.
template <Real T, class Tally>
[[nodiscard]] inline Candidate sharpened(const Query<T, Tally>& query, Candidate c) noexcept {
  if (!c.is_rough) return c;
  c.t = enclose(predicates::triangle_terms<double>(query.ray, query.data.triangles[c.block].triangle(c.lane)));
  c.is_rough = false;
  return c;
}

/// The sign of one's exact first value minus the other's.
template <Real T, class Tally>
[[nodiscard]] inline int compare(const Query<T, Tally>& query, const Candidate& one, const Candidate& other) noexcept {
  if (one.t.high < other.t.low) return -1;
  if (one.t.low > other.t.high) return 1;
  if (one.is_integer && other.is_integer) return compare_quotients(one, other);
  if (one.is_rough || other.is_rough) return compare(query, sharpened(query, one), sharpened(query, other));
  query.tally.template add<&Statistics::exact_orders>(1);
  return with_shape(query.data, one, [&](const auto& a) {
    return with_shape(query.data, other, [&](const auto& b) { return exact::compare_first(query.ray, a, b); });
  });
}

/// Whether one comes before the other: by exact first value, then index.
template <Real T, class Tally>
[[nodiscard]] inline bool comes_before(const Query<T, Tally>& query, const Candidate& one, const Candidate& other) noexcept {
  const int order = compare(query, one, other);
  return order != 0 ? order < 0 : one.index < other.index;
}

}  // namespace graze::scene
