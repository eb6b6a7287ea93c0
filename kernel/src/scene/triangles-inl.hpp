// Per target: the filter of predicates/triangle_filter.hpp on all lanes of a block. Included anew for each target by
// kernels.cpp.
#if defined(GRAZE_SCENE_TRIANGLES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_TRIANGLES_INL
#undef GRAZE_SCENE_TRIANGLES_INL
#else
#define GRAZE_SCENE_TRIANGLES_INL
#endif

#include "scene/boxes-inl.hpp"
#include "scene/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Vectors {
  V x, y, z;
};

template <class V>
HWY_INLINE Vectors<V> difference(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class V>
HWY_INLINE V dot(const Vectors<V>& a, const Vectors<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
template <class V>
HWY_INLINE Vectors<V> cross(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
template <class V>
HWY_INLINE V magnitude_sum(const Vectors<V>& v) {
  return hn::Add(hn::Add(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// Corner a, b or c of a block's triangles, a vector of them from the i-th on; of floats in D's precision.
template <class D>
HWY_INLINE Vectors<hn::Vec<D>> corners(D d, const TriangleBlock<float>& block, int c, std::size_t i) {
  const auto axis = [&](int k) HWY_ATTR {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
      return hn::Load(d, block.corners[c][k] + i);
    } else {
      return load_as_double(d, block.corners[c][k] + i);
    }
  };
  return {axis(0), axis(1), axis(2)};
}
template <class D>
HWY_INLINE Vectors<hn::Vec<D>> corners(D d, const TriangleBlock<double>& block, int c, std::size_t i) {
#if HWY_ARCH_X86 && HWY_MAX_BYTES >= 64
  // One instruction that Highway does not offer finds eight of sixteen numbers.
  const __m512i place = _mm512_maskz_cvtepu8_epi64(0xff, hn::LoadU(hn::CappedTag<std::uint8_t, 8>(), block.place[c] + i).raw);
  const auto axis = [&](int k) HWY_ATTR {
    const auto first = hn::LoadU(d, block.points[k]);
    const auto last = hn::LoadU(hn::Half<D>(), block.points[k] + width);
    return hn::Vec<D>{_mm512_permutex2var_pd(first.raw, place, _mm512_castpd256_pd512(last.raw))};
  };
#else
  // By loads and blends: a gather would be slower, and tables are too short.
  constexpr std::size_t lanes = hn::MaxLanes(D());
  static_assert(lanes == 1 || lanes == 2 || lanes == 4);
  const std::uint8_t* const place = block.place[c] + i;
  const auto axis = [&](int k) HWY_ATTR {
    const double* const points = block.points[k];
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, points[place[0]]);
#else
    const auto two = [&](int j)
                         HWY_ATTR { return hn::OddEven(hn::Set(d, points[place[j + 1]]), hn::Set(d, points[place[j]])); };
#if HWY_MAX_BYTES >= 32
    return hn::ConcatUpperLower(d, two(2), two(0));
#else
    return two(0);
#endif
#endif
  };
#endif
  return {axis(0), axis(1), axis(2)};
}

/// Where distance / whole lies against x, as predicates::test_bound.
template <class M>
struct BoundTests {
  M above, below;
};
template <class D, class V>
HWY_INLINE auto test_bound(D d, hn::TFromD<D> x, V whole, V distance, V error, V distance_error) {
  const V f = hn::NegMulAdd(hn::Set(d, x), whole, distance);
  const V bound =
      hn::Mul(hn::Set(d, hn::TFromD<D>(1.25)), hn::MulAdd(hn::Set(d, numeric::magnitude(x)), error, distance_error));
  return BoundTests<decltype(hn::Gt(f, bound))>{hn::Gt(f, bound), hn::Lt(f, hn::Neg(bound))};
}

/// The verdicts on a block's lanes, in the format's own precision: the formulas and bounds of predicates::triangle_terms<T> and
/// predicates::verdict, operation by operation; a product and a sum are one FMA or two operations. The ray's range must be
/// plain. Lanes that are certainly beyond ray.end are missed. The terms are told to `tell(i, ...)`, of a vector from the i-th
/// lane on.
template <Real T, class Tell>
HWY_INLINE LaneVerdicts settle(const RayLanes<T>& ray, const TriangleBlock<T>& block, Tell tell) {
  using numeric::Ordinary;
  const hn::CappedTag<T, width> d;
  using V = hn::Vec<decltype(d)>;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<T, width>());
  const auto all = [d](const Vec3<T>& p) HWY_ATTR { return Vectors<V>{hn::Set(d, p.x), hn::Set(d, p.y), hn::Set(d, p.z)}; };
  const Vectors<V> direction = all(ray.ray.direction), origin = all(ray.ray.origin);
  const V along = hn::Set(d, ray.direction_sum), low = hn::Set(d, Ordinary<T, T>::low), high = hn::Set(d, Ordinary<T, T>::high);
  LaneVerdicts out{0, 0};
  for (std::size_t i = 0; i < width; i += lanes) {
    const Vectors<V> a = corners(d, block, 0, i), e1 = difference(corners(d, block, 1, i), a),
                     e2 = difference(corners(d, block, 2, i), a), from_a = difference(origin, a);
    const Vectors<V> h = cross(direction, e2), g = cross(from_a, e1);
    const V determinant = dot(e1, h), sign = hn::And(determinant, hn::Set(d, T(-0.0))), whole = hn::Abs(determinant);
    const V u = hn::Xor(dot(from_a, h), sign), v = hn::Xor(dot(direction, g), sign), w = hn::Sub(hn::Sub(whole, u), v);
    const V s = hn::Add(magnitude_sum(e1), magnitude_sum(e2)), r = hn::Add(magnitude_sum(from_a), s);
    const V scale = hn::Mul(hn::Set(d, predicates::triangle_error * numeric::unit_of<T>), hn::Mul(s, r));
    const V error = hn::Mul(scale, along), distance_error = hn::Mul(scale, s);
    const auto is_ordinary = hn::And(hn::Ge(hn::Min(s, along), low), hn::Le(hn::Add(along, r), high));
    const auto is_bounded = hn::And(is_ordinary, hn::Gt(whole, error));
    const V least = hn::Min(hn::Min(u, v), w);
    const auto is_beside = hn::Lt(least, hn::Neg(error));
    const V distance = hn::Xor(dot(e2, g), sign);
    auto is_above = hn::Gt(distance, distance_error);
    auto is_outside = hn::Lt(distance, hn::Neg(distance_error));
    if (!ray.has_default_range) {
      const auto from = test_bound(d, ray.ray.t_min, whole, distance, error, distance_error);
      is_above = from.above;
      is_outside = from.below;
      if (ray.has_t_max) {
        const auto to = test_bound(d, ray.t_max, whole, distance, error, distance_error);
        is_above = hn::And(is_above, to.below);
        if (!ray.is_t_max_greater) is_outside = hn::Or(is_outside, to.above);
      }
    }
    if (ray.has_end) is_outside = hn::Or(is_outside, test_bound(d, ray.end, whole, distance, error, distance_error).above);
    const auto is_missed = hn::And(is_bounded, hn::Or(is_beside, is_outside));
    const auto is_face = hn::And(hn::AndNot(is_outside, is_bounded), hn::And(hn::Gt(least, error), is_above));
    tell(i, determinant, whole, distance, error, distance_error);
    out.face |= bits_of_mask(d, is_face) << i;
    out.uncertain |= bits_of_mask(d, hn::Not(hn::Or(is_face, is_missed))) << i;
  }
  return out;
}

/// The same, telling nothing.
template <Real T>
HWY_INLINE LaneVerdicts settle(const RayLanes<T>& ray, const TriangleBlock<T>& block) {
  return settle(ray, block, [](std::size_t, const auto&...) HWY_ATTR {});
}
/// The same, keeping the terms.
template <Real T>
HWY_INLINE LaneVerdicts settle(const RayLanes<T>& ray, const TriangleBlock<T>& block, LaneTerms<T>& terms) {
  const hn::CappedTag<T, width> d;
  using V = hn::Vec<decltype(d)>;
  terms.front = 0;
  return settle(ray, block, [&](std::size_t i, V determinant, V whole, V distance, V error, V distance_error) HWY_ATTR {
    // The determinant is -d . n.
    terms.front |= bits_of_mask(d, hn::Gt(determinant, hn::Zero(d))) << i;
    hn::Store(whole, d, terms.whole + i);
    hn::Store(distance, d, terms.distance + i);
    hn::Store(error, d, terms.error + i);
    hn::Store(distance_error, d, terms.distance_error + i);
  });
}

/// For rays with `is_integer`: no operation rounds, so nothing needs a bound.
template <Real T>
HWY_INLINE void settle_integers(const Ray<T>& ray, const TriangleBlock<T>& block, IntegerVerdicts& out) {
  const hn::CappedTag<double, width> d;
  using V = hn::Vec<decltype(d)>;
  constexpr std::size_t lanes = hn::MaxLanes(hn::CappedTag<double, width>());
  const auto vector = [&](const Vec3<T>& p) HWY_ATTR {
    return Vectors<V>{hn::Set(d, static_cast<double>(p.x)), hn::Set(d, static_cast<double>(p.y)),
                      hn::Set(d, static_cast<double>(p.z))};
  };
  const Vectors<V> direction = vector(ray.direction), origin = vector(ray.origin);
  const V zero = hn::Zero(d);
  for (std::size_t i = 0; i < width; i += lanes) {
    const Vectors<V> a = corners(d, block, 0, i), e1 = difference(corners(d, block, 1, i), a),
                     e2 = difference(corners(d, block, 2, i), a), from_a = difference(origin, a);
    const Vectors<V> h = cross(direction, e2), g = cross(from_a, e1);
    const V determinant = dot(e1, h), sign = hn::And(determinant, hn::Set(d, -0.0)), whole = hn::Abs(determinant);
    const V u = hn::Xor(dot(from_a, h), sign), v = hn::Xor(dot(direction, g), sign), w = hn::Sub(hn::Sub(whole, u), v);
    const V distance = hn::Xor(dot(e2, g), sign), least = hn::Min(hn::Min(u, v), hn::Min(w, distance));
    const auto is_crossed = hn::Gt(whole, zero);
    out.met |= bits_of_mask(d, hn::And(is_crossed, hn::Ge(least, zero))) << i;
    out.inner |= bits_of_mask(d, hn::And(is_crossed, hn::Gt(least, zero))) << i;
    out.uncertain |= bits_of_mask(d, hn::And(hn::Eq(whole, zero), hn::Eq(distance, zero))) << i;
    // The determinant is -d . n.
    out.front |= bits_of_mask(d, hn::Gt(determinant, zero)) << i;
    hn::Store(whole, d, out.whole + i);
    hn::Store(u, d, out.u + i);
    hn::Store(v, d, out.v + i);
    hn::Store(distance, d, out.distance + i);
  }
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
