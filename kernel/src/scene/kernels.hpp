// The queries' hot loops, compiled for each SIMD target; the machine's best is chosen when a scene is made.
#pragma once

#include <span>
#include <vector>

#include "scene/query.hpp"

namespace graze::scene {

/// The hits of a ray, none of an invalid one; all answers are exact, so they are the same from every target.
template <Real T, class Tally>
struct QueryKernels {
  /// The closest, rounded, and the ray's status, to an answer that says miss.
  void (*closest)(const Query<T, Tally>& query, SceneHit<T>& answer) noexcept;
  bool (*any)(const Query<T, Tally>& query) noexcept;
  std::uint64_t (*count)(const Query<T, Tally>& query) noexcept;
  /// All, in no order; or those alone that may share the least t. Throws std::bad_alloc.
  void (*collect)(const Query<T, Tally>& query, bool only_closest, std::vector<Candidate>& found);
  SceneHit<T> (*rounded)(const Query<T, Tally>& query, const Candidate& candidate) noexcept;
  /// The ray is {point, +x}, valid, and the scene closed.
  Place (*inside)(const Query<T, Tally>& query) noexcept;
};

/// The same of each ray of a span, invalid ones among them, as the single queries answer, rounded.
template <Real T>
struct BatchKernels {
  void (*closest)(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options,
                  SceneHit<T>* answers) noexcept;
  void (*any)(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options, bool* answers) noexcept;
  void (*count)(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options,
                std::uint64_t* answers) noexcept;
  /// As box_ray, of a valid ray.
  BoxRay (*box_ray)(const Space& space, const Box& root, const Ray<T>& ray) noexcept;
};

struct Kernels {
  QueryKernels<float, Silent> silent_float;
  QueryKernels<float, Counting> counting_float;
  QueryKernels<double, Silent> silent_double;
  QueryKernels<double, Counting> counting_double;
  BatchKernels<float> batches_float;
  BatchKernels<double> batches_double;
  /// The children whose boxes the ray meets, as bits, and where it enters them.
  unsigned (*meet_boxes)(const BoxRay& ray, const Node& node, float* entry) noexcept;

  template <Real T, class Tally>
  [[nodiscard]] const QueryKernels<T, Tally>& of() const noexcept {
    if constexpr (std::same_as<T, float> && std::same_as<Tally, Silent>) {
      return silent_float;
    } else if constexpr (std::same_as<T, float>) {
      return counting_float;
    } else if constexpr (std::same_as<Tally, Silent>) {
      return silent_double;
    } else {
      return counting_double;
    }
  }
  template <Real T>
  [[nodiscard]] const BatchKernels<T>& batches() const noexcept {
    if constexpr (std::same_as<T, float>) {
      return batches_float;
    } else {
      return batches_double;
    }
  }
};

template <Real T, class Tally>
[[nodiscard]] inline const QueryKernels<T, Tally>& kernels(const Query<T, Tally>& query) noexcept {
  return query.data.kernels->template of<T, Tally>();
}

}  // namespace graze::scene
