// Per target: a ray as the filter on lanes and as the boxes see it. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_RAYS_INL
#undef GRAZE_SCENE_RAYS_INL
#else
#define GRAZE_SCENE_RAYS_INL
#endif

#include "scene/box_ray.hpp"
#include "scene/data.hpp"
#include "scene/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// The headers' own functions are compiled for the baseline: called from here, each would pay for the change of registers'
/// width. Flattened they are compiled for the target.
template <Real T>
struct Rays {
  RayLanes<T> lanes;
  BoxRay box;
};
template <Real T>
HWY_NOINLINE HWY_FLATTEN Rays<T> rays_of(const Data<T>& data, const Ray<T>& ray) {
  return {RayLanes<T>(ray, data.extent), box_ray(data.space, data.root, ray)};
}
template <Real T>
HWY_NOINLINE HWY_FLATTEN void end_rays_at(RayLanes<T>& lanes, BoxRay& box, double t) {
  lanes.end_at(t);
  box.end_at(t);
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
