// A query's hits as they are answered: rounded.
#pragma once

#include "rounding/quotients.hpp"
#include "scene/query.hpp"

namespace graze::scene {

/// `face` is rounding::face for doubles.
template <Real T, class Tally, class Face>
[[nodiscard]] inline SceneHit<T> rounded(const Query<T, Tally>& query, const Candidate& c, Face face) noexcept {
  query.tally.template add<&Statistics::roundings>(1);
  SceneHit<T> hit;
  hit.shape = c.shape;
  hit.index = c.index;
  if (c.shape == Shape::sphere) {
    hit.sphere = intersect(query.ray, query.data.spheres[c.block].sphere(c.lane));
  } else {
    const Triangle<T> triangle = query.data.triangles[c.block].triangle(c.lane);
    if (!c.is_face) {
      hit.triangle = intersect(query.ray, triangle);
    } else if constexpr (std::same_as<T, double>) {
      hit.triangle = face(query.ray, triangle, c.terms);
    } else {
      hit.triangle = rounding::face(query.ray, triangle, c.terms);
    }
  }
  return hit;
}

}  // namespace graze::scene
