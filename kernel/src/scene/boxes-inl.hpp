// Per target: eight boxes at once. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_BOXES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_BOXES_INL
#undef GRAZE_SCENE_BOXES_INL
#else
#define GRAZE_SCENE_BOXES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The first lanes' mask as bits.
template <class D, class M>
HWY_INLINE unsigned bits_of_mask(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0];
}

/// Numbers as doubles, a vector of them.
template <class D>
HWY_INLINE auto load_as_double(D d, const double* from) {
  return hn::LoadU(d, from);
}
template <class D>
HWY_INLINE auto load_as_double(D d, const float* from) {
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
}

/// The lanes that hold a primitive.
HWY_INLINE unsigned lanes_of(const std::uint32_t (&index)[width]) {
  const hn::CappedTag<std::uint32_t, width> d;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<std::uint32_t, width>());
  unsigned out = 0;
  for (std::size_t i = 0; i < width; i += lanes) {
    out |= bits_of_mask(d, hn::Ne(hn::LoadU(d, index + i), hn::Set(d, no_primitive))) << i;
  }
  return out;
}

/// Where a ray enters boxes, and which it meets.
template <class V, class M>
struct Entries {
  V first;
  M met;
};

/// A ray as many boxes at once see it.
template <class D>
struct RayAtBoxes {
  using V = hn::Vec<D>;
  V reciprocal[3], far_reciprocal[3], near_offset[3], far_offset[3];
  std::uint32_t near_row[3], far_row[3];

  HWY_INLINE explicit RayAtBoxes(const BoxRay& ray) {
    const D d;
    for (int k = 0; k < 3; ++k) {
      reciprocal[k] = hn::Set(d, ray.reciprocal[k]);
      far_reciprocal[k] = hn::Set(d, ray.far_reciprocal[k]);
      near_offset[k] = hn::Set(d, ray.near_offset[k]);
      far_offset[k] = hn::Set(d, ray.far_offset[k]);
      near_row[k] = ray.near_row[k];
      far_row[k] = ray.far_row[k];
    }
  }

  /// Of a vector of a node's children, from the i-th on; `high` is the ray's. See box_ray.hpp.
  HWY_INLINE auto enter(const Node& node, float high, std::size_t i) const {
    const D d;
    V near[3], far[3];
    for (int k = 0; k < 3; ++k) {
      near[k] = hn::MulSub(hn::Load(d, node.rows() + near_row[k] + i), reciprocal[k], near_offset[k]);
      far[k] = hn::MulSub(hn::Load(d, node.rows() + far_row[k] + i), far_reciprocal[k], far_offset[k]);
    }
    // In pairs, for a shorter chain.
    const V first = hn::Max(hn::Max(near[0], near[1]), hn::Max(near[2], hn::Zero(d)));
    const V last = hn::Min(hn::Min(far[0], far[1]), hn::Min(far[2], hn::Set(d, high)));
    const auto met = hn::Le(first, last);
    return Entries<V, decltype(hn::Le(first, last))>{first, met};
  }
};
using BoxLanes = hn::CappedTag<float, width>;

/// The children whose boxes the ray meets, as bits; where it enters them to `entry`. For a question about one child: a ray on
/// its way asks `meet`.
HWY_INLINE unsigned meet_boxes(const RayAtBoxes<BoxLanes>& ray, float high, const Node& node, float* HWY_RESTRICT entry) {
  const BoxLanes d;
  constexpr std::size_t lanes = hn::MaxLanes(BoxLanes());
  unsigned bits = 0;
  for (std::size_t i = 0; i < width; i += lanes) {
    const auto entries = ray.enter(node, high, i);
    hn::Store(entries.first, d, entry + i);
    bits |= bits_of_mask(d, entries.met) << i;
  }
  return bits;
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
