// Per target: a ray as the filter on lanes and as the boxes see it. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_RAYS_INL
#undef GRAZE_SCENE_RAYS_INL
#else
#define GRAZE_SCENE_RAYS_INL
#endif

#include "exact/validate.hpp"
#include "scene/box_ray-inl.hpp"
#include "scene/data.hpp"
#include "scene/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

template <Real T>
HWY_INLINE void bring(const Space& space, const Box& root, const Ray<T>& ray, bool is_plain, BoxRay& out) {
  if (HWY_LIKELY(is_plain)) {
    to_box_ray(space, root, ray, out);
  } else {
    to_any_box_ray(space, root, ray, out);
  }
}

/// Whether the ray is plain, and its status.
struct Admission {
  bool is_plain;
  Status status;
};
template <Real T>
HWY_INLINE Admission admit(const Ray<T>& ray) {
  const bool is_one = is_plain(ray);
  return {is_one, HWY_LIKELY(is_one) ? Status::ok : exact::status_of(ray, true, false)};
}

/// The headers' own functions are compiled for the baseline: called, each would pay for the change of registers' width. So what
/// makes this is flattened.
template <Real T>
struct Rays {
  HWY_INLINE Rays(const Data<T>& data, const Ray<T>& ray, bool is_plain) : lanes(ray, data.extent) {
    bring(data.space, data.root, ray, is_plain, box);
  }

  RayLanes<T> lanes;
  BoxRay box;
};

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
