// The hierarchy's shape: from the top binned by the surface area heuristic (Wald 2007) into two, down to the leaves; then, from
// the leaves, which of the halves become children of wide nodes, for the least sum of areas (Ylitie, Karras & Laine 2017, 3.1).
#pragma once

#include <array>
#include <functional>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

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
  Branch *one = nullptr, *other = nullptr;  ///< null for a leaf
  /// cost[i - 1] as at most i children; of these share[i] are the first half's, 0 where fewer children are no worse. Of eight
  /// there is no cost: they have a node of their own.
  std::array<float, width - 1> cost;
  std::array<std::uint8_t, width + 1> share{};

  [[nodiscard]] bool is_leaf() const noexcept { return one == nullptr; }
};

/// Where branches live: each in one place to its end, many at once allocated and freed.
class Branches {
 public:
  [[nodiscard]] Branch* make() {
    if (chunks_.empty() || used_ == chunk) {
      chunks_.push_back(std::make_unique<std::array<Branch, chunk>>());
      used_ = 0;
    }
    return &(*chunks_.back())[used_++];
  }
  /// Takes over another's branches.
  void adopt(Branches&& other) {
    if (chunks_.empty()) used_ = other.used_;
    // The last is the one that is being filled.
    chunks_.insert(chunks_.begin(), std::make_move_iterator(other.chunks_.begin()),
                   std::make_move_iterator(other.chunks_.end()));
  }

 private:
  static constexpr std::size_t chunk = 128;
  std::vector<std::unique_ptr<std::array<Branch, chunk>>> chunks_;
  std::size_t used_ = 0;
};

/// The children of a branch's node.
struct Children {
  int size = 0;
  std::array<const Branch*, width> branches;

  explicit Children(const Branch& branch) noexcept;

 private:
  void take(const Branch& branch, int most) noexcept;
};

/// Whether references of one kind, at most eight, fit into one leaf; half of eight do.
using Fits = std::function<bool(std::span<const Reference>)>;

/// Sorts the references so that each leaf's are a range; `root` holds all. Throws std::bad_alloc.
[[nodiscard]] const Branch* divide(Pages<Reference>& references, const Box& root, const Fits& fits, Threads threads,
                                   Branches& branches);

}  // namespace graze::scene
