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
HWY_NOINLINE HWY_FLATTEN double first_tau_of(const Ray<T>& ray, int exponent) {
  return first_tau(ray, exponent);
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

using FourFloats = hn::CappedTag<float, 4>;

/// Of a direction with its longest component, in all lanes: 1 / D and x of box_ray.hpp, and where they are as told there.
struct Slopes {
  hn::Vec<FourFloats> reciprocal;
  int exponent;
  bool is_ordinary;
};
/// From floats the same numbers as from doubles, as a quotient rounded to double and then to float is as if rounded once: no
/// component is subnormal, so those that are not steep are normal; the steep ones may overflow, as in the conversion.
template <class D>
HWY_INLINE Slopes slopes_of(D d, hn::Vec<D> given) {
  using T = hn::TFromD<D>;
  constexpr bool is_float = sizeof(T) < sizeof(double);
  constexpr int most = is_float ? 100 : 900;
  const auto longest = hn::MaxOfLanes(d, hn::Abs(given));
  const int exponent = exponent_of(hn::GetLane(longest));
  const auto power = hn::And(longest, hn::BitCast(d, hn::Set(hn::RebindToSigned<D>(), numeric::infinity_bits<T>)));
  // The division need not wait for the power of two.
  const auto reciprocal = hn::Mul(hn::Div(hn::Set(d, 1), given), power);
  const bool is_ordinary = (exponent >= -most) & (exponent < most);
  if constexpr (is_float) {
    return {reciprocal, exponent, is_ordinary};
  } else {
    return {hn::DemoteTo(FourFloats(), reciprocal), exponent, is_ordinary};
  }
}

/// As box_ray, step by step, so with the same bits, of a plain ray, to `out`: what is returned would be copied, and have to
/// wait for what was written by parts.
template <Real T>
HWY_INLINE void to_box_ray(const Space& space, const Box& root, const Ray<T>& ray, BoxRay& out) {
  const hn::CappedTag<double, 4> d;
  const FourFloats narrow;
  const hn::RebindToSigned<FourFloats> rows;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const auto set_float = [narrow](float x) HWY_ATTR { return hn::Set(narrow, x); };
  // Three numbers and what follows them, which is zero from then on.
  const T* const numbers = reinterpret_cast<const T*>(&ray);
  const hn::CappedTag<T, 4> own;
  const auto given = hn::IfThenElseZero(hn::FirstN(own, 3), hn::LoadU(own, numbers + 3));
  const Slopes slopes = slopes_of(own, given);
  const auto as_doubles = [&]() HWY_ATTR {
    const V place = hn::Sub(hn::Mul(set(0.25), load_as_double(d, numbers)), hn::LoadU(d, space.quarter_origin));
    return hn::Mul(place, set(space.scale));
  };
  const auto as_floats = [&]() HWY_ATTR {
    if constexpr (sizeof(T) < sizeof(double)) {
      const auto difference = hn::Sub(hn::LoadU(narrow, numbers), hn::LoadU(narrow, space.narrow_origin));
      return hn::Mul(difference, set_float(space.narrow_scale));
    } else {
      return hn::DemoteTo(narrow, as_doubles());
    }
  };
  auto f = hn::IfThenElseZero(hn::FirstN(narrow, 3), as_floats()), error = set_float(BoxRay::least_error);
  const bool is_ordinary = slopes.is_ordinary & (sizeof(T) == sizeof(double) || space.is_narrow);
  // Beyond 2^40, which an infinite coordinate is too, a ray is blind.
  const bool is_far = bits_of_mask(narrow, hn::Gt(hn::Abs(f), set_float(BoxRay::near_by))) != 0;
  if (HWY_UNLIKELY(!is_ordinary || (is_far && !(hn::GetLane(hn::MaxOfLanes(narrow, hn::Abs(f))) <= 0x1p40f)))) {
    to_any_box_ray(space, root, ray, out);
    return;
  }
  const int time_exponent = slopes.exponent + space.exponent;
  double start = HWY_LIKELY(numeric::magnitude_bits(ray.t_min) == 0) ? 0 : first_tau_of(ray, time_exponent);
  if (is_far | (start != 0)) {
    const V e = as_doubles();
    static_assert(sizeof(Box) == 6 * sizeof(float));
    const V direction = hn::Mul(load_as_double(d, numbers + 3), set(power_of_two(-slopes.exponent))),
            r = hn::Div(set(1), direction);
    const V low = load_as_double(d, root.low), high = hn::PromoteTo(d, hn::Shuffle0321(hn::LoadU(narrow, root.low + 2)));
    const V plane = hn::IfThenElse(hn::Gt(direction, hn::Zero(d)), low, high);
    const V margin = hn::Mul(hn::Mul(set(0x1p-45), hn::Add(set(1), hn::Abs(e))), hn::Abs(r));
    const V entry = hn::Sub(hn::Mul(hn::Sub(plane, e), r), margin), first = set(start);
    const auto counts = hn::And(hn::FirstN(d, 3), hn::Ge(hn::Abs(direction), set(0x1p-30)));
    const V from = hn::MaxOfLanes(d, hn::IfThenElse(counts, hn::Max(first, hn::Min(entry, set(0x1p60))), first));
    start = hn::GetLane(from);
    const V moved = hn::Mul(from, direction);
    f = hn::IfThenElseZero(hn::FirstN(narrow, 3), hn::DemoteTo(narrow, hn::Add(e, moved)));
    error = hn::DemoteTo(
        narrow, hn::Add(hn::Mul(set(0x1p-49), hn::Add(hn::Abs(e), hn::Abs(moved))), set(BoxRay::least_error_at(start))));
  }
  auto g = hn::Add(hn::Mul(set_float(0x1p-20f), hn::Abs(f)), error), reciprocal = slopes.reciprocal;
  const auto is_steep = hn::Gt(hn::Abs(reciprocal), set_float(BoxRay::steepest));
  if (HWY_UNLIKELY((bits_of_mask(narrow, is_steep) & 7) != 0)) {
    const auto largest = hn::MaxOfLanes(narrow, hn::Abs(f));
    g = hn::IfThenElse(is_steep, hn::Add(g, hn::Mul(set_float(0x1p-58f), hn::Add(set_float(1), largest))), g);
    reciprocal = hn::IfThenElse(is_steep, hn::CopySign(set_float(BoxRay::steepest), reciprocal), reciprocal);
  }
  const auto far_reciprocal = hn::Mul(reciprocal, set_float(1 + BoxRay::slack));
  hn::StoreU(reciprocal, narrow, out.reciprocal);
  hn::StoreU(far_reciprocal, narrow, out.far_reciprocal);
  hn::StoreU(hn::Add(hn::Mul(f, reciprocal), hn::Mul(g, hn::Abs(reciprocal))), narrow, out.near_offset);
  hn::StoreU(hn::Sub(hn::Mul(f, far_reciprocal), hn::Mul(g, hn::Abs(far_reciprocal))), narrow, out.far_offset);

  // As BoxRay::set.
  const auto row = hn::ShiftLeft<3>(hn::Iota(rows, 0)), other = hn::Add(row, hn::Set(rows, 3 * width));
  const auto is_reversed = hn::RebindMask(rows, hn::Lt(reciprocal, hn::Zero(narrow)));
  hn::StoreU(hn::IfThenElse(is_reversed, other, row), rows, reinterpret_cast<std::int32_t*>(out.near_row));
  hn::StoreU(hn::IfThenElse(is_reversed, row, other), rows, reinterpret_cast<std::int32_t*>(out.far_row));
  out.reach_from(time_exponent, start);
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
