// From primitives to nodes and blocks.
#include "scene/build.hpp"

#include <span>
#include <tuple>

#include "scene/divide.hpp"
#include "scene/fill.hpp"
#include "scene/parallel.hpp"
#include "scene/splits.hpp"

namespace graze::scene {
namespace {

/// How many nodes and blocks the branches come to.
struct Sizes {
  std::size_t nodes = 0, triangles = 0, spheres = 0;
};

void count(const Branch& branch, const Pages<Reference>& references, Sizes& sizes) noexcept {
  ++sizes.nodes;
  const Children children(branch);
  for (int i = 0; i < children.size; ++i) {
    const Branch& child = *children.branches[i];
    if (!child.is_leaf()) {
      count(child, references, sizes);
    } else {
      ++(references[child.range.begin].is_sphere != 0 ? sizes.spheres : sizes.triangles);
    }
  }
}

/// A leaf whose block is to be filled, and whose child it is.
struct Leaf {
  Child child;
  std::uint32_t begin, end;
  std::uint32_t node, slot;
};

/// Writes the nodes, depth first, and lists the leaves.
template <Real T>
std::uint32_t write(const Branch& branch, const Pages<Reference>& references, Data<T>& data, Sizes& written,
                    std::vector<Leaf>& leaves) {
  const auto self = static_cast<std::uint32_t>(written.nodes++);
  for (int i = 0; i < width; ++i) data.nodes[self].set(i, Box::empty(), Child::nothing());
  const Children children(branch);
  for (int i = 0; i < children.size; ++i) {
    const Range& range = children.branches[i]->range;
    Child child;
    if (!children.branches[i]->is_leaf()) {
      child = Child::node(write(*children.branches[i], references, data, written, leaves));
    } else {
      child = references[range.begin].is_sphere != 0 ? Child::spheres(static_cast<std::uint32_t>(written.spheres++))
                                                     : Child::triangles(static_cast<std::uint32_t>(written.triangles++));
      leaves.push_back({child, static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end), self,
                        static_cast<std::uint32_t>(i)});
    }
    data.nodes[self].set(i, range.box, child);
  }
  return self;
}

/// Of several references to one triangle in one leaf the leaf keeps one.
void drop_repeats(std::vector<Leaf>& leaves, Pages<Reference>& references) {
  for (Leaf& leaf : leaves) {
    const auto begin = references.begin() + leaf.begin, end = references.begin() + leaf.end;
    std::sort(begin, end, [](const Reference& one, const Reference& other) { return one.index < other.index; });
    const auto last =
        std::unique(begin, end, [](const Reference& one, const Reference& other) { return one.index == other.index; });
    leaf.end = static_cast<std::uint32_t>(last - references.begin());
  }
}

/// Where each triangle is that is in several leaves.
[[nodiscard]] std::vector<Listing> listings_of(const std::vector<Leaf>& leaves, const Pages<Reference>& references) {
  std::vector<Listing> all;
  for (const Leaf& leaf : leaves) {
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) all.push_back({references[i].index, leaf.node, leaf.slot});
  }
  std::sort(all.begin(), all.end(), [](const Listing& one, const Listing& other) {
    return std::tie(one.primitive, one.node, one.slot) < std::tie(other.primitive, other.node, other.slot);
  });
  std::vector<Listing> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_repeated = (i != 0 && all[i - 1].primitive == all[i].primitive) ||
                             (i + 1 < all.size() && all[i + 1].primitive == all[i].primitive);
    if (is_repeated) out.push_back(all[i]);
  }
  return out;
}

}  // namespace

template <Real T>
void build(Data<T>& data, const BuildOptions& options) {
  const Threads threads = options.threads;
  data.nodes.clear();
  data.triangles.clear();
  data.spheres.clear();
  data.listings.clear();
  data.root = Box::empty();
  if (data.size() == 0) return;
  Pages<Reference> references = references_of(data, threads);
  for (const Reference& r : references) data.root.include(r.box());
  if (options.spatial_splits) split(data, references);
  Branches branches;
  const auto fits_in_block = [&data](std::span<const Reference> some) {
    return some[0].is_sphere != 0 ||
           fits(data, static_cast<int>(some.size()), [&](int i) -> std::uint32_t { return some[i].index; });
  };
  const Branch* const top = divide(references, data.root, fits_in_block, threads, branches);
  Sizes sizes, written;
  count(*top, references, sizes);
  data.nodes.resize(sizes.nodes);
  std::vector<Leaf> leaves;
  leaves.reserve(sizes.triangles + sizes.spheres);
  write(*top, references, data, written, leaves);
  branches = {};
  if (options.spatial_splits) {
    drop_repeats(leaves, references);
    data.listings = listings_of(leaves, references);
  }
  data.triangles.resize(sizes.triangles);
  data.spheres.resize(sizes.spheres);
  for_ranges(leaves.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Leaf& leaf = leaves[i];
      const int size = static_cast<int>(leaf.end - leaf.begin);
      const auto index = [from = references.data() + leaf.begin](int lane) -> std::uint32_t { return from[lane].index; };
      if (leaf.child.is_spheres()) {
        fill(data, data.spheres[leaf.child.index()], size, index);
      } else {
        fill(data, data.triangles[leaf.child.index()], size, index);
      }
    }
  });
}

template void build(Data<float>&, const BuildOptions&);
template void build(Data<double>&, const BuildOptions&);

}  // namespace graze::scene
