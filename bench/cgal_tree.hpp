// CGAL's tree of boxes over triangles, with exact predicates and inexact constructions.
#pragma once

#include <memory>
#include <vector>

#include "fuzz/mesh/mesh.hpp"
#include "graze/types.hpp"

namespace graze::bench {

class CgalTree {
 public:
  /// Coordinates as they are.
  explicit CgalTree(const fuzz::Mesh& mesh);
  ~CgalTree();

  /// How many of the rays meet something; the nearest is found for each.
  [[nodiscard]] std::size_t closest(const std::vector<Ray<double>>& rays) const;
  /// How many of the rays meet something.
  [[nodiscard]] std::size_t any(const std::vector<Ray<double>>& rays) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace graze::bench
