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

/// Of a vector of a node's children, from the i-th on. See box_ray.hpp.
template <class D>
HWY_INLINE auto enter(D d, const BoxRay& ray, const Node& node, std::size_t i) {
  auto first = hn::Zero(d), last = hn::Set(d, ray.high);
  for (int k = 0; k < 3; ++k) {
    const auto reciprocal = hn::Set(d, ray.reciprocal[k]);
    const auto near = hn::Load(d, node.rows() + ray.near_row[k] + i), far = hn::Load(d, node.rows() + ray.far_row[k] + i);
    first = hn::Max(first, hn::MulSub(near, reciprocal, hn::Set(d, ray.near_offset[k])));
    last = hn::Min(last, hn::MulSub(far, reciprocal, hn::Set(d, ray.far_offset[k])));
  }
  const auto met = hn::Le(first, hn::Mul(last, hn::Set(d, 1 + BoxRay::slack)));
  return Entries<decltype(first), decltype(hn::Le(first, last))>{first, met};
}

/// The children whose boxes the ray meets, as bits; where it enters them to `entry`.
HWY_INLINE unsigned meet_boxes(const BoxRay& ray, const Node& node, float* HWY_RESTRICT entry) {
  const hn::CappedTag<float, width> d;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<float, width>());
  unsigned bits = 0;
  for (std::size_t i = 0; i < width; i += lanes) {
    const auto entries = enter(d, ray, node, i);
    hn::Store(entries.first, d, entry + i);
    bits |= bits_of_mask(d, entries.met) << i;
  }
  return bits;
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
