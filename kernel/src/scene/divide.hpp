// The hierarchy's shape: from the top binned by the surface area heuristic (Wald 2007) into two, down to the leaves; then, from
// the leaves, which of the halves become children of wide nodes, for the least sum of areas (Ylitie, Karras & Laine 2017, 3.1).
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

/// A range and its halves, down to the leaves; and the least that a ray may be expected to pay for it, as one child of a wide
/// node or as several.
struct Branch {
  Range range;
  std::unique_ptr<Branch> one, other;  ///< null for a leaf
  /// cost[i - 1] as at most i children; of these share[i] are the first half's, 0 where fewer children are no worse. Of eight
  /// there is no cost: they have a node of their own.
  std::array<float, width - 1> cost;
  std::array<std::uint8_t, width + 1> share{};

  [[nodiscard]] bool is_leaf() const noexcept { return one == nullptr; }
};

/// The children of a branch's node.
struct Children {
  int size = 0;
  std::array<const Branch*, width> branches;

  explicit Children(const Branch& branch) noexcept;

 private:
  void take(const Branch& branch, int most) noexcept;
};

/// Sorts the references so that each leaf's are a range; `root` holds all. Throws std::bad_alloc.
[[nodiscard]] std::unique_ptr<Branch> divide(Pages<Reference>& references, const Box& root, Threads threads);

}  // namespace graze::scene
