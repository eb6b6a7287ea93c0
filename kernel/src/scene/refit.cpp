// New shapes in the leaves of a hierarchy, new boxes above them.
#include "scene/build.hpp"

namespace graze::scene {
namespace {

template <Real T, class Block>
[[nodiscard]] Box reload(const Data<T>& data, Block& block) noexcept {
  Box box = Box::empty();
  for (int i = 0; i < width; ++i) {
    const std::uint32_t primitive = block.index[i];
    load(data, block, i, primitive == no_primitive ? block.index[0] : primitive);
    block.index[i] = primitive;
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

template void refit(Data<float>&) noexcept;
template void refit(Data<double>&) noexcept;

}  // namespace graze::scene
