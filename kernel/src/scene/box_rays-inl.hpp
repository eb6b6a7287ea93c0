// Per target: eight rays brought into box space at once. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_BOX_RAYS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_BOX_RAYS_INL
#undef GRAZE_SCENE_BOX_RAYS_INL
#else
#define GRAZE_SCENE_BOX_RAYS_INL
#endif

#include "scene/boxes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What box_ray makes of eight rays, those that are ordinary: valid, 0 <= t without upper end, no component subnormal in float,
/// none of the direction beyond 2^900, none of the origin beyond 2^40 in box space.
struct BoxRays {
  static constexpr int size = 8;
  unsigned ordinary;  ///< bits
  alignas(64) float reciprocal[3][size], near_offset[3][size], far_offset[3][size];
  alignas(64) double start[size];
  alignas(64) std::int64_t time_exponent[size];

  /// The i-th, which is ordinary.
  [[nodiscard]] HWY_INLINE BoxRay operator[](int i) const {
    BoxRay out;
    for (int k = 0; k < 3; ++k) out.set(k, reciprocal[k][i], near_offset[k][i], far_offset[k][i]);
    out.start = start[i];
    out.time_exponent = static_cast<int>(time_exponent[i]);
    return out;
  }
};

/// Bits of those whose range is the default and, in float, no component of which is subnormal: they might be read as zero.
template <Real T>
HWY_INLINE unsigned plain_rays(const Ray<T>* rays) {
  unsigned bits = 0;
  for (int i = 0; i < BoxRays::size; ++i) {
    const auto& [e, d, t_min, t_max] = rays[i];
    bool is_plain = numeric::is_default_range(rays[i]);
    if constexpr (sizeof(T) < sizeof(double)) {
      for (const T x : {e.x, e.y, e.z, d.x, d.y, d.z}) is_plain &= numeric::magnitude_bits(x) - 1 >= 0x007fffffu;
    }
    bits |= static_cast<unsigned>(is_plain) << i;
  }
  return bits;
}

/// The operations of box_ray one by one on all lanes, so it gives the same bits.
template <Real T>
HWY_NOINLINE HWY_FLATTEN void box_rays(const Space& space, const Box& root, const Ray<T>* rays, BoxRays& out) {
  const hn::CappedTag<double, BoxRays::size> d;
  const hn::Rebind<float, decltype(d)> narrow;
  const hn::RebindToSigned<decltype(d)> integers;
  using V = hn::Vec<decltype(d)>;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<double, BoxRays::size>());
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const V one = set(1), huge = set(0x1p60);
  alignas(64) double columns[6][BoxRays::size];
  for (int i = 0; i < BoxRays::size; ++i) {
    const auto& [e, v, t_min, t_max] = rays[i];
    int c = 0;
    for (const T x : {e.x, e.y, e.z, v.x, v.y, v.z}) columns[c++][i] = static_cast<double>(x);
  }
  out.ordinary = 0;
  for (std::size_t i = 0; i < BoxRays::size; i += lanes) {
    V e[3], direction[3], f[3];
    V far = hn::Zero(d), longest = far, sum = far, distance = far;
    for (int k = 0; k < 3; ++k) {
      const V x = hn::Mul(set(0.25), hn::Load(d, columns[k] + i));
      e[k] = hn::Mul(hn::Sub(x, set(space.quarter_origin[k])), set(space.scale));
      direction[k] = hn::Load(d, columns[3 + k] + i);
      far = hn::Max(far, hn::Abs(e[k]));
      longest = hn::Max(longest, hn::Abs(direction[k]));
      // Sums tell NaNs too, which a maximum may lose.
      distance = hn::Add(distance, hn::Abs(e[k]));
      sum = hn::Add(sum, hn::Abs(direction[k]));
    }
    const auto is_ordinary =
        hn::And(hn::Le(distance, set(0x1p40)), hn::And(hn::Ge(longest, set(0x1p-900)), hn::Le(sum, set(0x1p900))));
    out.ordinary |= bits_of_mask(d, is_ordinary) << i;
    const auto biased = hn::ShiftRight<52>(hn::BitCast(integers, longest));
    const V scale = hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(integers, 2046), biased)));
    hn::Store(hn::Add(biased, hn::Set(integers, space.exponent - 1023)), integers, out.time_exponent + i);

    V r[3], start = hn::Zero(d);
    for (int k = 0; k < 3; ++k) {
      direction[k] = hn::Mul(direction[k], scale);
      r[k] = hn::Div(one, direction[k]);
    }
    const auto is_outside = hn::Gt(far, one);
    if (!hn::AllFalse(d, is_outside)) {
      for (int k = 0; k < 3; ++k) {
        const V plane = hn::IfThenElse(hn::Gt(direction[k], hn::Zero(d)), set(root.low[k]), set(root.high[k]));
        const V margin = hn::Mul(hn::Mul(set(0x1p-45), hn::Add(one, hn::Abs(e[k]))), hn::Abs(r[k]));
        const V entry = hn::Sub(hn::Mul(hn::Sub(plane, e[k]), r[k]), margin);
        const auto counts = hn::Ge(hn::Abs(direction[k]), set(0x1p-30));
        start = hn::IfThenElse(counts, hn::Max(start, hn::Min(entry, huge)), start);
      }
      start = hn::IfThenElseZero(is_outside, start);
    }
    hn::Store(start, d, out.start + i);

    V largest = hn::Zero(d);
    for (int k = 0; k < 3; ++k) {
      f[k] = hn::Add(e[k], hn::Mul(start, direction[k]));
      largest = hn::Max(largest, hn::Abs(f[k]));
    }
    for (int k = 0; k < 3; ++k) {
      const V moved = hn::Abs(hn::Mul(start, direction[k]));
      const V error = hn::Add(
          hn::Add(hn::Mul(set(0x1p-50), hn::Add(hn::Abs(e[k]), moved)), hn::Mul(set(0x1p-110), hn::Abs(start))), set(0x1p-100));
      V g = hn::Add(hn::Add(hn::Mul(set(0x1p-21), hn::Abs(f[k])), hn::Mul(set(2), error)), set(0x1p-90));
      const auto is_flat = hn::Lt(hn::Abs(direction[k]), set(0x1p-60));
      g = hn::IfThenElse(is_flat, hn::Add(g, hn::Mul(set(0x1p-58), hn::Add(one, largest))), g);
      const auto reciprocal = hn::DemoteTo(narrow, hn::IfThenElse(is_flat, hn::CopySign(huge, direction[k]), r[k]));
      const V exact = hn::PromoteTo(d, reciprocal), offset = hn::Mul(f[k], exact), width = hn::Mul(g, hn::Abs(exact));
      hn::Store(reciprocal, narrow, out.reciprocal[k] + i);
      hn::Store(hn::DemoteTo(narrow, hn::Add(offset, width)), narrow, out.near_offset[k] + i);
      hn::Store(hn::DemoteTo(narrow, hn::Sub(offset, width)), narrow, out.far_offset[k] + i);
    }
  }
  out.ordinary &= plain_rays(rays);
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
