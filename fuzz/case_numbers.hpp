// The numbers of a query in the order of its case line.
#pragma once

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// Calls visit(number) for each number of a query, const or not, in the order of its case line; of a ray's range, t_min and
/// t_max, last.
template <class Query, class Visit>
constexpr void for_each_number(Query& query, Visit visit) {
  const auto each = [&](auto&... number) { (visit(number), ...); };
  const auto vector = [&](auto& v) { each(v.x, v.y, v.z); };
  if constexpr (requires { query.ray; }) {
    vector(query.ray.origin);
    vector(query.ray.direction);
  } else if constexpr (requires { query.point.z; }) {
    vector(query.point);
  } else {
    each(query.point.x, query.point.y);
  }
  if constexpr (requires { query.sphere; }) {
    vector(query.sphere.center);
    each(query.sphere.radius);
  } else if constexpr (requires { query.triangle; }) {
    vector(query.triangle.a);
    vector(query.triangle.b);
    vector(query.triangle.c);
  } else if constexpr (requires { query.plane; }) {
    each(query.plane.a, query.plane.b, query.plane.c, query.plane.d);
  } else {
    each(query.line.a, query.line.b, query.line.c);
  }
  if constexpr (requires { query.ray; }) each(query.ray.t_min, query.ray.t_max);
}

}  // namespace graze::fuzz
