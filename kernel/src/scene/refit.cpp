// New shapes in the leaves of a hierarchy, new boxes above them.
#include <algorithm>
#include <array>

#include "scene/build.hpp"
#include "scene/fill.hpp"

namespace graze::scene {
namespace {

/// How many lanes hold something, and which primitives.
struct Lanes {
  int size = 0;
  std::array<std::uint32_t, width> primitives;

  template <class Block>
  explicit Lanes(const Block& block) noexcept {
    std::copy_n(block.index, width, primitives.begin());
    while (size < width && block.index[size] != no_primitive) ++size;
  }
  [[nodiscard]] std::uint32_t operator()(int lane) const noexcept { return primitives[static_cast<std::size_t>(lane)]; }
};

template <Real T, class Block>
[[nodiscard]] Box reload(const Data<T>& data, Block& block) noexcept {
  const Lanes lanes(block);
  fill(data, block, lanes.size, lanes);
  Box box = Box::empty();
  for (int i = 0; i < lanes.size; ++i) {
    if constexpr (requires { block.triangle(0); }) {
      box.include(box_of(data.space, block.triangle(i)));
    } else {
      box.include(box_of(data.space, block.sphere(i)));
    }
  }
  return box;
}

}  // namespace

template <Real T>
bool still_fits(const Data<T>& data) noexcept {
  if constexpr (sizeof(T) < sizeof(double)) return true;
  return std::ranges::all_of(data.triangles, [&](const TriangleBlock<T>& block) {
    const Lanes lanes(block);
    return fits(data, lanes.size, lanes);
  });
}

template <Real T>
void refit(Data<T>& data) noexcept {
  // Children come after their parents.
  for (std::size_t n = data.nodes.size(); n-- > 0;) {
    Node& node = data.nodes[n];
    for (int i = 0; i < width; ++i) {
      const Child child = node.children[i];
      if (child.is_nothing()) continue;
      Box box = Box::empty();
      if (!child.is_leaf()) {
        const Node& inner = data.nodes[child.index()];
        for (int j = 0; j < width; ++j) {
          if (!inner.children[j].is_nothing()) box.include(inner.box(j));
        }
      } else if (child.is_spheres()) {
        box = reload(data, data.spheres[child.index()]);
      } else {
        box = reload(data, data.triangles[child.index()]);
      }
      node.set(i, box, child);
    }
  }
  data.root = Box::empty();
  for (int i = 0; i < width && !data.nodes.empty(); ++i) {
    if (!data.nodes[0].children[i].is_nothing()) data.root.include(data.nodes[0].box(i));
  }
}

template bool still_fits(const Data<float>&) noexcept;
template bool still_fits(const Data<double>&) noexcept;
template void refit(Data<float>&) noexcept;
template void refit(Data<double>&) noexcept;

}  // namespace graze::scene
