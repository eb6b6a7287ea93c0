// Per target: the way of a ray through the hierarchy. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_WALK_INL
#undef GRAZE_SCENE_WALK_INL
#else
#define GRAZE_SCENE_WALK_INL
#endif

#include "scene/boxes-inl.hpp"
#include "scene/places.hpp"
#include "scene/query.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Visits the leaves that the ray meets from `next` on, nearer ones first as far as their boxes tell, until visitor.leaf(child)
/// returns true, and returns whether one did. The visitor may shorten the ray.
template <Real T, class Tally, class Visitor>
HWY_INLINE bool walk(const Query<T, Tally>& query, BoxRay& ray, Visitor& visitor, Child next) {
  if (query.data.nodes.empty()) return false;
  const Node* const nodes = query.data.nodes.data();
  const Places<T> places(query.data);
  const RayAtBoxes<BoxLanes> at_boxes(ray);
  const bool is_blind = ray.is_blind;
  float high = ray.high;
  struct Entry {
    Child child;
    float entry;
  };
  Entry stack[deepest * (width - 1) + 1];
  Entry* top = stack;
  alignas(64) float entry[width];
  while (true) {
    while (!next.is_leaf()) {
      query.tally.template add<&Statistics::nodes>(1);
      const Node& node = nodes[next.index()];
      unsigned met = meet_boxes(at_boxes, high, node, entry);
      if (HWY_UNLIKELY(is_blind)) met &= node.occupied();
      if (met == 0) break;
      const int one = __builtin_ctz(met);
      met &= met - 1;
      if (met == 0) {
        next = node.children[one];
        continue;
      }
      if ((met & (met - 1)) == 0) {
        // Two are the most common: no branch on which is nearer.
        const int other = __builtin_ctz(met);
        const float at_one = entry[one], at_other = entry[other];
        const Child child_one = node.children[one], child_other = node.children[other];
        const bool is_swapped = at_other < at_one;
        *top++ = {is_swapped ? child_one : child_other, is_swapped ? at_one : at_other};
        places.fetch(top[-1].child);
        next = is_swapped ? child_other : child_one;
        continue;
      }
      // The nearest is next; the others go on the stack, the farthest first: an insertion sort, for there are few.
      Entry* const base = top;
      *top++ = {node.children[one], entry[one]};
      do {
        const int i = __builtin_ctz(met);
        met &= met - 1;
        const float at = entry[i];
        Entry* hole = top++;
        for (; hole > base && hole[-1].entry < at; --hole) *hole = hole[-1];
        *hole = {node.children[i], at};
        places.fetch(node.children[i]);
      } while (met != 0);
      next = (--top)->child;
    }
    if (next.is_leaf()) {
      query.tally.template add<&Statistics::leaves>(1);
      if (visitor.leaf(next)) return true;
      high = ray.high;
    }
    do {
      if (top == stack) return false;
      --top;
    } while (top->entry > high);
    next = top->child;
  }
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
