// Per target: a query's hits as they are answered. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_ROUNDED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_ROUNDED_INL
#undef GRAZE_SCENE_ROUNDED_INL
#else
#define GRAZE_SCENE_ROUNDED_INL
#endif

#include "scene/face-inl.hpp"
#include "scene/query.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// To `hit`, which says miss.
template <Real T, class Tally>
HWY_INLINE void round_to(SceneHit<T>& hit, const Query<T, Tally>& query, const Candidate& c) noexcept {
  query.tally.template add<&Statistics::roundings>(1);
  hit.shape = c.shape;
  hit.index = c.index;
  if (HWY_UNLIKELY(c.shape == Shape::sphere)) {
    hit.sphere = intersect(query.ray, query.data.spheres[c.block].sphere(c.lane));
  } else {
    const TriangleBlock<T>& block = query.data.triangles[c.block];
    if (HWY_LIKELY(c.is_face)) {
      face(query.ray, block, c.lane, c.bounds, hit.triangle);
    } else {
      hit.triangle = intersect(query.ray, block.triangle(c.lane));
    }
  }
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
