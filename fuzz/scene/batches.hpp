// A scene asked about a span of rays, held against the same rays asked one by one.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/same_bits.hpp"
#include "graze/scene.hpp"

namespace graze::fuzz {

template <Real T>
[[nodiscard]] bool same_bits(const SceneHit<T>& a, const SceneHit<T>& b) {
  return a.status == b.status && a.shape == b.shape && a.index == b.index && same_bits(a.triangle, b.triangle) &&
         same_bits(a.sphere, b.sphere);
}

/// A sentence about the first answer of closest, any or count that differs by a bit. The rays may be invalid.
template <Real T>
[[nodiscard]] std::optional<std::string> find_batch_fault(const Scene<T>& scene, std::span<const Ray<T>> rays,
                                                          const QueryOptions& options, Threads threads = Threads::mine) {
  // What no query answers, so that a ray left out is seen.
  SceneHit<T> unanswered;
  unanswered.index = no_primitive - 1;
  std::vector<SceneHit<T>> closest(rays.size(), unanswered);
  std::vector<std::uint64_t> count(rays.size(), ~std::uint64_t(0));
  const auto any = std::make_unique<bool[]>(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) any[i] = !scene.any(rays[i], options);
  scene.closest(rays, closest, options, threads);
  scene.count(rays, count, options, threads);
  scene.any(rays, std::span(any.get(), rays.size()), options, threads);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::string where = ": ray " + std::to_string(i) + " of a batch of " + std::to_string(rays.size());
    if (!same_bits(closest[i], scene.closest(rays[i], options))) return "closest" + where;
    if (count[i] != scene.count(rays[i], options)) return "count" + where;
    if (any[i] != scene.any(rays[i], options)) return "any" + where;
  }
  return {};
}

}  // namespace graze::fuzz
