// Per target: the way of a ray through the hierarchy. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_WALK_INL
#undef GRAZE_SCENE_WALK_INL
#else
#define GRAZE_SCENE_WALK_INL
#endif

#include "scene/agenda-inl.hpp"
#include "scene/places.hpp"
#include "scene/query.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Visits the leaves that the ray meets from `next` on, nearer ones first as far as their boxes tell, until visitor.leaf(child)
/// returns true, and returns whether one did. The visitor may shorten the ray. `in_order`: it pays to visit nearer ones first,
/// as far as that is cheap; else only the nearest of a node's children is sure to come first.
template <bool in_order, Real T, class Tally, class Visitor>
HWY_INLINE bool walk(const Query<T, Tally>& query, BoxRay& ray, Visitor& visitor, Child next) {
  if (query.data.nodes.empty()) return false;
  const Node* const nodes = query.data.nodes.data();
  const Places<T> places(query.data);
  const bool is_blind = ray.is_blind;
  float high = ray.high;
  Agenda<deepest*(width - 1) + 1> agenda;
  agenda.start(next);
  while (true) {
    // Loaded anew after each leaf, which is a call, and so keeps no vector in its register.
    const RayAtBoxes<BoxLanes> at_boxes(ray);
    while (!agenda.next.is_leaf()) {
      query.tally.template add<&Statistics::nodes>(1);
      const Node& node = nodes[agenda.next.index()];
      const Met met = meet(at_boxes, high, is_blind, node);
      if (!met.is_any) {
        agenda.pop();
        continue;
      }
      const auto spread = agenda.template spread<in_order>(met.keys, node);
      agenda.next = spread.nearest;
      places.fetch(agenda.next);
      agenda.size = spread.size;
      places.fetch(agenda.child[agenda.size - 1]);
    }
    if (agenda.next.is_nothing()) return false;
    query.tally.template add<&Statistics::leaves>(1);
    if (visitor.leaf(agenda.next)) return true;
    if (ray.high != high) {
      high = ray.high;
      agenda.cut(high);
    }
    agenda.pop();
  }
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
