// Per target: which of the leaves that hold a triangle speaks for it. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_HOME_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_HOME_INL
#undef GRAZE_SCENE_HOME_INL
#else
#define GRAZE_SCENE_HOME_INL
#endif

#include "scene/boxes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Whether a triangle that the ray meets is to be counted in this block: the first of its leaves in the listings counts whose
/// box the walk does not pass by. That leaf is visited, for what a box test passes it passes for all boxes around it: it is
/// monotonic in their bounds. Of a triangle that is met there is such a leaf: the one around the hit. For rays that are not
/// shortened on their way.
template <Real T>
HWY_NOINLINE bool is_home_of_listed(const Data<T>& data, const BoxRay& ray, std::uint32_t primitive, std::uint32_t block) {
  auto at = std::lower_bound(data.listings.begin(), data.listings.end(), primitive,
                             [](const Listing& one, std::uint32_t index) { return one.primitive < index; });
  if (at == data.listings.end() || at->primitive != primitive) return true;
  alignas(64) float entry[width];
  for (; at != data.listings.end() && at->primitive == primitive; ++at) {
    const Node& node = data.nodes[at->node];
    const bool is_met = (meet_boxes(RayAtBoxes<BoxLanes>(ray), ray.high, node, entry) >> at->slot & 1) != 0;
    if (is_met && entry[at->slot] <= ray.high) return node.children[at->slot].index() == block;
  }
  return false;
}

/// The same; without spatial splits every block is the only one.
template <Real T>
HWY_INLINE bool is_home(const Data<T>& data, const BoxRay& ray, std::uint32_t primitive, std::uint32_t block) {
  return HWY_LIKELY(data.listings.empty()) || is_home_of_listed(data, ray, primitive, block);
}

/// Of some lanes of a block those that are counted there.
template <Real T>
HWY_INLINE unsigned at_home(const Data<T>& data, const BoxRay& ray, const TriangleBlock<T>& block, std::uint32_t number,
                            unsigned lanes) {
  if (HWY_LIKELY(data.listings.empty())) return lanes;
  unsigned out = 0;
  for (unsigned rest = lanes; rest != 0; rest &= rest - 1) {
    const int i = __builtin_ctz(rest);
    out |= static_cast<unsigned>(is_home(data, ray, block.index[i], number)) << i;
  }
  return out;
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
