// The hierarchy's shape, from the top: binned by the surface area heuristic (Wald 2007) into two, the largest part again, until
// there are eight children or all are leaves.
#pragma once

#include <array>
#include <memory>

#include "scene/references.hpp"

namespace graze::scene {

/// A part of the references.
struct Range {
  std::size_t begin, end;
  Box box;
  int depth;

  [[nodiscard]] std::size_t size() const noexcept { return end - begin; }
};

/// A node while its children are not numbered yet.
struct Draft {
  int size = 0;
  std::array<Range, width> ranges;
  std::array<std::unique_ptr<Draft>, width> children;  ///< null for a leaf
};

/// Sorts the references so that each leaf's are a range; `root` holds all. Throws std::bad_alloc.
[[nodiscard]] std::unique_ptr<Draft> divide(Pages<Reference>& references, const Box& root, Threads threads);

}  // namespace graze::scene
