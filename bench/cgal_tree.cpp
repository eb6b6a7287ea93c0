#include "bench/cgal_tree.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace graze::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 point(const Vec3<double>& p) {
  return {p.x, p.y, p.z};
}
Kernel::Ray_3 query(const Ray<double>& ray) {
  const Vec3<double>& d = ray.direction;
  return {point(ray.origin), Kernel::Vector_3(d.x, d.y, d.z)};
}

}  // namespace

struct CgalTree::Tree {
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

CgalTree::CgalTree(const fuzz::Mesh& mesh) : tree_(std::make_unique<Tree>()) {
  for (const auto& [a, b, c] : mesh.triangles) {
    tree_->triangles.emplace_back(point(mesh.points[a]), point(mesh.points[b]), point(mesh.points[c]));
  }
  tree_->tree.rebuild(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->tree.build();
}

CgalTree::~CgalTree() = default;

std::size_t CgalTree::closest(const std::vector<Ray<double>>& rays) const {
  std::size_t hits = 0;
  for (const Ray<double>& ray : rays) hits += tree_->tree.first_intersected_primitive(query(ray)).has_value() ? 1 : 0;
  return hits;
}

std::size_t CgalTree::any(const std::vector<Ray<double>>& rays) const {
  std::size_t hits = 0;
  for (const Ray<double>& ray : rays) hits += tree_->tree.do_intersect(query(ray)) ? 1 : 0;
  return hits;
}

}  // namespace graze::bench
