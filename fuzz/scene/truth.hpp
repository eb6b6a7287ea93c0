// What a scene ought to answer: every primitive asked of the oracle, hits ordered by their exact values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fuzz/scene/draft.hpp"
#include "oracle/oracle.hpp"

namespace graze::fuzz {

/// The sign of one - other.
[[nodiscard]] int compare(const oracle::Exact& one, const oracle::Exact& other);

template <Real T>
struct SceneTruth {
  std::vector<SceneHit<T>> hits;  ///< by exact first value, then index
  std::size_t ties = 0;           ///< how many of them share the least
};

template <Real T>
[[nodiscard]] SceneTruth<T> scene_truth(const SceneDraft<T>& scene, const Ray<T>& ray, const QueryOptions& options);

/// Asks the scene everything about the ray; a sentence about the first answer that is wrong.
template <Real T>
[[nodiscard]] std::optional<std::string> find_scene_fault(const Scene<T>& scene, const SceneDraft<T>& draft, const Ray<T>& ray,
                                                          const QueryOptions& options);

/// Where a finite point lies against the draft's surface, which is closed: by the hits on a way out that meets no edge and no
/// corner. Unknown where no such way is found, which is for chance to decide.
template <Real T>
[[nodiscard]] Place place_truth(const SceneDraft<T>& scene, const Vec3<T>& point, Random& random);

}  // namespace graze::fuzz
