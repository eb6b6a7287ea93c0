// Per target: a ray brought into box space, its axes in lanes. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_BOX_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_BOX_RAY_INL
#undef GRAZE_SCENE_BOX_RAY_INL
#else
#define GRAZE_SCENE_BOX_RAY_INL
#endif

#include "scene/box_ray.hpp"
#include "scene/boxes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Whether the ray is valid and none of its numbers subnormal, which might be read as zero: from the bits of all eight at once.
template <Real T>
HWY_INLINE bool is_plain(const Ray<T>& ray) {
  const hn::CappedTag<T, 8> d;
  const hn::RebindToSigned<decltype(d)> bits;
  using Integer = hn::TFromD<decltype(bits)>;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<T, 8>());
  constexpr Integer infinity = numeric::infinity_bits<T>, least_normal = Integer(1) << (numeric::FormatOf<T>::precision - 1);
  static_assert(sizeof(Ray<T>) == 8 * sizeof(T));
  unsigned zeros = 0, normals = 0;
  for (std::size_t i = 0; i < 8; i += lanes) {
    const auto magnitude = hn::BitCast(bits, hn::Abs(hn::LoadU(d, reinterpret_cast<const T*>(&ray) + i)));
    zeros |= bits_of_mask(bits, hn::Eq(magnitude, hn::Zero(bits))) << i;
    normals |= bits_of_mask(bits, hn::And(hn::Gt(magnitude, hn::Set(bits, least_normal - 1)),
                                          hn::Lt(magnitude, hn::Set(bits, infinity))))
               << i;
  }
  constexpr unsigned direction = 0x38, end = 0x80, all = 0xff;
  if (numeric::bits_of(ray.t_max) == numeric::infinity_bits<T>) {
    return ((zeros | normals | end) == all) & ((zeros & direction) != direction);
  }
  return ((zeros | normals) == all) & ((zeros & direction) != direction) & (ray.t_min <= ray.t_max);
}

/// Rays with a range of their own, or none that is plain; not inlined, for they would cost the others registers.
template <Real T>
HWY_NOINLINE HWY_FLATTEN double first_tau(const BoxRay& out, const Ray<T>& ray) {
  return out.first_tau(ray);
}
template <Real T>
HWY_NOINLINE HWY_FLATTEN void end_with(BoxRay& out, const Ray<T>& ray) {
  out.end_with(ray);
}
template <Real T>
HWY_NOINLINE HWY_FLATTEN void to_any_box_ray(const Space& space, const Box& root, const Ray<T>& ray, BoxRay& out) {
  out = box_ray(space, root, ray);
}

#if HWY_MAX_BYTES >= 32

/// As box_ray, step by step, so with the same bits, of a plain ray, to `out`: what is returned would be copied, and have to
/// wait for what was written by parts.
template <Real T>
HWY_INLINE void to_box_ray(const Space& space, const Box& root, const Ray<T>& ray, BoxRay& out) {
  const hn::CappedTag<double, 4> d;
  const hn::Rebind<float, decltype(d)> narrow;
  const hn::RebindToSigned<decltype(d)> integers;
  const hn::RebindToSigned<decltype(narrow)> rows;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  // Three numbers and what follows them, which is zero from then on.
  const auto axes = hn::FirstN(d, 3);
  const T* const numbers = reinterpret_cast<const T*>(&ray);
  const V place = hn::Sub(hn::Mul(set(0.25), load_as_double(d, numbers)), hn::LoadU(d, space.quarter_origin));
  const V e = hn::IfThenElseZero(axes, hn::Mul(place, set(space.scale)));
  const V given = hn::IfThenElseZero(axes, load_as_double(d, numbers + 3));
  const V longest = hn::MaxOfLanes(d, hn::Abs(given));
  const double far = hn::GetLane(hn::MaxOfLanes(d, hn::Abs(e))), length = hn::GetLane(longest);
  if (HWY_UNLIKELY(!((far <= 0x1p40) & (length >= 0x1p-900) & (length <= 0x1p900)))) {
    to_any_box_ray(space, root, ray, out);
    return;
  }
  const auto exponent = hn::ShiftRight<52>(hn::BitCast(integers, longest));
  const V scale = hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(integers, 2046), exponent)));
  const V inverse_scale = hn::BitCast(d, hn::ShiftLeft<52>(exponent));
  // The division need not wait for the scale, a power of two.
  const V direction = hn::Mul(given, scale), r = hn::Mul(hn::Div(set(1), given), inverse_scale);
  out.time_exponent = static_cast<int>(hn::GetLane(exponent)) - 1023 + space.exponent;

  const double first = HWY_LIKELY(numeric::magnitude_bits(ray.t_min) == 0) ? 0 : first_tau(out, ray);
  V start = set(first);
  if ((far > BoxRay::near_by) | (first != 0)) {
    static_assert(sizeof(Box) == 6 * sizeof(float));
    const V low = load_as_double(d, root.low), high = hn::PromoteTo(d, hn::Shuffle0321(hn::LoadU(narrow, root.low + 2)));
    const V plane = hn::IfThenElse(hn::Gt(direction, hn::Zero(d)), low, high);
    const V margin = hn::Mul(hn::Mul(set(0x1p-45), hn::Add(set(1), hn::Abs(e))), hn::Abs(r));
    const V entry = hn::Sub(hn::Mul(hn::Sub(plane, e), r), margin);
    const auto counts = hn::Ge(hn::Abs(direction), set(0x1p-30));
    start = hn::MaxOfLanes(d, hn::IfThenElse(counts, hn::Max(start, hn::Min(entry, set(0x1p60))), start));
  }
  out.start = hn::GetLane(start);

  const V moved = hn::Mul(start, direction), f = hn::Add(e, moved);
  const V error = hn::Add(hn::Mul(set(0x1p-49), hn::Add(hn::Abs(e), hn::Abs(moved))), set(BoxRay::least_error(out.start)));
  V g = hn::Add(hn::Mul(set(0x1p-21), hn::Abs(f)), error), nearly_r = r;
  const auto is_flat = hn::Lt(hn::Abs(direction), set(0x1p-60));
  if (HWY_UNLIKELY((bits_of_mask(d, is_flat) & 7) != 0)) {
    const V largest = hn::MaxOfLanes(d, hn::Abs(f));
    g = hn::IfThenElse(is_flat, hn::Add(g, hn::Mul(set(0x1p-58), hn::Add(set(1), largest))), g);
    nearly_r = hn::IfThenElse(is_flat, hn::CopySign(set(0x1p60), direction), r);
  }
  const auto reciprocal = hn::DemoteTo(narrow, nearly_r);
  const V exact = hn::PromoteTo(d, reciprocal), offset = hn::Mul(f, exact), half_width = hn::Mul(g, hn::Abs(exact));
  hn::StoreU(reciprocal, narrow, out.reciprocal);
  hn::StoreU(hn::DemoteTo(narrow, hn::Add(offset, half_width)), narrow, out.near_offset);
  hn::StoreU(hn::DemoteTo(narrow, hn::Sub(offset, half_width)), narrow, out.far_offset);

  // As BoxRay::set.
  const auto row = hn::ShiftLeft<3>(hn::Iota(rows, 0)), other = hn::Add(row, hn::Set(rows, 3 * width));
  const auto is_reversed = hn::RebindMask(rows, hn::Lt(reciprocal, hn::Zero(narrow)));
  hn::StoreU(hn::IfThenElse(is_reversed, other, row), rows, reinterpret_cast<std::int32_t*>(out.near_row));
  hn::StoreU(hn::IfThenElse(is_reversed, row, other), rows, reinterpret_cast<std::int32_t*>(out.far_row));
  if (HWY_UNLIKELY(numeric::is_finite(ray.t_max))) end_with(out, ray);
}

#else

template <Real T>
HWY_INLINE void to_box_ray(const Space& space, const Box& root, const Ray<T>& ray, BoxRay& out) {
  to_any_box_ray(space, root, ray, out);
}

#endif

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
