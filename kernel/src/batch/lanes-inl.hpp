// Lanes of one instruction set. Included once for each by Highway's foreach_target.
#if defined(GRAZE_BATCH_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_LANES_INL_HPP
#undef GRAZE_BATCH_LANES_INL_HPP
#else
#define GRAZE_BATCH_LANES_INL_HPP
#endif

#include <cstring>
#include <utility>

#include "batch/verdicts.hpp"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace graze::batch {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::CappedTag<T, 16>;
template <class D>
using Lanes = hn::Vec<D>;
template <class D>
using LaneMask = hn::Mask<D>;

/// The bits of a mask, lane 0 lowest.
template <class D>
HWY_INLINE std::uint64_t bits([[maybe_unused]] D d, LaneMask<D> mask) {
#if HWY_TARGET == HWY_AVX2
  // One instruction, where what is below takes a byte of it and widens that.
  const auto v = hn::VecFromMask(d, mask).raw;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
    return static_cast<unsigned>(_mm256_movemask_ps(v));
  } else {
    return static_cast<unsigned>(_mm256_movemask_pd(v));
  }
#elif HWY_TARGET == HWY_SSE4
  const auto v = hn::VecFromMask(d, mask).raw;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
    return static_cast<unsigned>(_mm_movemask_ps(v));
  } else {
    return static_cast<unsigned>(_mm_movemask_pd(v));
  }
#elif HWY_TARGET == HWY_AVX3
  return mask.raw;
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < (hn::MaxLanes(d) + 7) / 8; ++i) out |= std::uint64_t(bytes[i]) << (8 * i);
  return out;
#endif
}

/// The lanes whose sign bit is set.
template <class D>
HWY_INLINE LaneMask<D> sign_mask([[maybe_unused]] D d, Lanes<D> v) {
#if HWY_TARGET <= HWY_SSE4 && HWY_ARCH_X86
  return hn::MaskFromVec(v);  // x86 reads just that bit
#else
  const hn::RebindToSigned<D> di;
  return hn::RebindMask(d, hn::Lt(hn::BitCast(di, v), hn::Zero(di)));
#endif
}

/// min(|a|, |b|), where that is |min(a, b)|.
template <class D>
HWY_INLINE Lanes<D> least_magnitude([[maybe_unused]] D d, Lanes<D> a, Lanes<D> b) {
#if HWY_TARGET == HWY_AVX3
  constexpr int least_of_magnitudes = 2, positive = 2 << 2;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
    return Lanes<D>{_mm512_range_ps(a.raw, b.raw, least_of_magnitudes | positive)};
  } else {
    return Lanes<D>{_mm512_range_pd(a.raw, b.raw, least_of_magnitudes | positive)};
  }
#else
  return hn::Abs(hn::Min(a, b));
#endif
}

/// Whether a > b in every lane of all vectors that were included.
template <class D>
class AllGreater {
 public:
#if HWY_TARGET == HWY_AVX3
  // The comparison takes the mask so far, and is all that it takes.
  HWY_INLINE AllGreater() : all_(hn::Eq(hn::Zero(D()), hn::Zero(D()))) {}
  HWY_INLINE void include(Lanes<D> a, Lanes<D> b) {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
      all_ = {_mm512_mask_cmp_ps_mask(all_.raw, a.raw, b.raw, _CMP_GT_OQ)};
    } else {
      all_ = {_mm512_mask_cmp_pd_mask(all_.raw, a.raw, b.raw, _CMP_GT_OQ)};
    }
  }
  HWY_INLINE bool holds() const {
    return hn::AllTrue(D(), all_);
  }

 private:
  LaneMask<D> all_;
#else
  HWY_INLINE AllGreater() : all_(hn::SignBit(D())) {}
  HWY_INLINE void include(Lanes<D> a, Lanes<D> b) {
    all_ = hn::And(all_, hn::VecFromMask(D(), hn::Gt(a, b)));
  }
  HWY_INLINE bool holds() const {
    return hn::AllTrue(D(), sign_mask(D(), all_));
  }

 private:
  Lanes<D> all_;  // the sign bits
#endif
};

/// Whether no number is negative, -0, infinite or a NaN: as integers these are the greatest.
template <class D>
class AllFinite {
 public:
  HWY_INLINE AllFinite() : greatest_(hn::Zero(DU())) {}
  HWY_INLINE void include(Lanes<D> x) { greatest_ = hn::Max(greatest_, hn::BitCast(DU(), x)); }
  HWY_INLINE bool holds() const {
    const hn::RebindToUnsigned<D> du;
    return hn::AllTrue(du, is_finite(hn::BitCast(du, greatest_)));
  }
  /// The same of each lane.
  static HWY_INLINE LaneMask<D> of(Lanes<D> x) {
    return hn::RebindMask(D(), is_finite(hn::BitCast(hn::RebindToUnsigned<D>(), x)));
  }

 private:
#if HWY_TARGET == HWY_SCALAR
  using DU = hn::RebindToUnsigned<D>;
#else
  // Of a double's halves the upper tells; a maximum of 64 bits takes several operations.
  using DU = hn::Repartition<std::uint32_t, D>;
#endif

  static HWY_INLINE auto is_finite(hn::Vec<hn::RebindToUnsigned<D>> bits) {
    return hn::Lt(bits, hn::BitCast(hn::RebindToUnsigned<D>(), hn::Inf(D())));
  }

  hn::Vec<DU> greatest_;
};

template <class D>
struct Vector3 {
  Lanes<D> x, y, z;
};

template <class D>
HWY_INLINE Vector3<D> operator-(const Vector3<D>& a, const Vector3<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

template <class D>
HWY_INLINE Lanes<D> dot(const Vector3<D>& a, const Vector3<D>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

template <class D>
HWY_INLINE Vector3<D> cross(const Vector3<D>& a, const Vector3<D>& b) {
  return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
          hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}

template <class D>
HWY_INLINE Lanes<D> magnitude_sum(const Vector3<D>& v) {
  return hn::Add(hn::Add(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// The numbers at lane i and after of n arrays, or, where not `many`, of n single numbers, which are spread over the lanes
/// once. Null columns stand for defaults, and are not read.
template <class D, int n, bool many>
class Source {
 public:
  using T = hn::TFromD<D>;
  static constexpr bool is_many = true;

  HWY_INLINE explicit Source(const Columns<T, n>& columns) : columns_(columns) {}
  HWY_INLINE Lanes<D> get(int k, std::size_t i) const { return hn::LoadU(D(), columns_.column[k] + i); }
  HWY_INLINE Vector3<D> vector(int k, std::size_t i) const { return {get(k, i), get(k + 1, i), get(k + 2, i)}; }
  HWY_INLINE void advance(std::size_t lanes) { advance_each(lanes, std::make_index_sequence<n>()); }

 private:
  /// Every column has a pointer of its own, in a register: with one index for all, each load would take an operation more.
  template <std::size_t... k>
  HWY_INLINE void advance_each(std::size_t lanes, std::index_sequence<k...>) {
    (advance_one(columns_.column[k], lanes), ...);
  }
  static HWY_INLINE void advance_one(const T*& column, std::size_t lanes) {
    column += column == nullptr ? 0 : lanes;
#if defined(__GNUC__)
    asm("" : "+r"(column));
#endif
  }

  Columns<T, n> columns_;
};

template <class D, int n>
class Source<D, n, false> {
 public:
  using T = hn::TFromD<D>;
  static constexpr bool is_many = false;

  HWY_INLINE explicit Source(const Columns<T, n>& columns) {
    for (int k = 0; k < n; ++k) spread_[k] = columns.column[k] == nullptr ? hn::Zero(D()) : hn::Set(D(), *columns.column[k]);
  }
  HWY_INLINE Lanes<D> get(int k, std::size_t) const { return spread_[k]; }
  HWY_INLINE Vector3<D> vector(int k, std::size_t i) const { return {get(k, i), get(k + 1, i), get(k + 2, i)}; }
  HWY_INLINE void advance(std::size_t) {}

 private:
  Lanes<D> spread_[n];
};

/// The last lanes, fewer than the vectors of a step: copied, so that nothing past the ends is read.
template <class T, int n>
class Tail {
 public:
  /// Columns of `count` lanes from `first` and zeros after those; of arrays alone.
  HWY_INLINE Columns<T, n> copy(const Columns<T, n>& columns, std::size_t first, std::size_t count) {
    Columns<T, n> copied{};
    for (int k = 0; k < n; ++k) {
      if (columns.column[k] == nullptr) continue;
      std::memset(buffer_[k], 0, sizeof buffer_[k]);
      std::memcpy(buffer_[k], columns.column[k] + first, count * sizeof(T));
      copied.column[k] = buffer_[k];
    }
    return copied;
  }

 private:
  T buffer_[n][64];
};

/// What a filter tells of up to 64 lanes, as bits; a hit counts where the lane is settled.
struct WordVerdict {
  std::uint64_t hit = 0, settled = 0, side = 0;

  HWY_INLINE void include(const WordVerdict& v, std::size_t lane) {
    hit |= v.hit << lane;
    settled |= v.settled << lane;
    side |= v.side << lane;
  }
};

/// Calls filter(rays, shapes, i) for vectors of the lanes from `first`, and gathers its verdicts in words.
template <class D, bool many_rays, bool many_shapes, int n, int m, class Filter>
HWY_INLINE void settle(D d, const Columns<hn::TFromD<D>, n>& ray_columns, const Columns<hn::TFromD<D>, m>& shape_columns,
                       std::size_t first, std::size_t count, Filter filter, Verdicts& out) {
  using T = hn::TFromD<D>;
  const std::size_t step = hn::Lanes(d);
  Source<D, n, many_rays> rays(ray_columns);
  Source<D, m, many_shapes> shapes(shape_columns);
  rays.advance(first);
  shapes.advance(first);
  Tail<T, many_rays ? n : 1> last_rays;
  Tail<T, many_shapes ? m : 1> last_shapes;
  for (std::size_t word = 0; 64 * word < count; ++word) {
    const std::size_t left = count - 64 * word < 64 ? count - 64 * word : 64;
    WordVerdict gathered;
    for (std::size_t lane = 0; lane < left; lane += 4 * step) {
      if (left - lane < 4 * step) {
        const std::size_t start = first + 64 * word + lane;
        if constexpr (many_rays) rays = Source<D, n, true>(last_rays.copy(ray_columns, start, left - lane));
        if constexpr (many_shapes) shapes = Source<D, m, true>(last_shapes.copy(shape_columns, start, left - lane));
      }
      // Four vectors: no load waits for another's vector, and all shifts but one are by constants.
      WordVerdict group;
      group.include(filter(rays, shapes, 0), 0);
      group.include(filter(rays, shapes, step), step);
      group.include(filter(rays, shapes, 2 * step), 2 * step);
      group.include(filter(rays, shapes, 3 * step), 3 * step);
      gathered.include(group, lane);
      rays.advance(4 * step);
      shapes.advance(4 * step);
    }
    out.hit[word] = gathered.hit & gathered.settled;
    out.doubt[word] = ~gathered.settled;
    out.side[word] = gathered.side;
  }
}

/// The same for the sides that are arrays. FilterOf<D, has_range> is the filter.
template <template <class, bool> class FilterOf, bool has_range, class T, int m>
HWY_INLINE void settle_sides(const Run<T, m>& run, std::size_t first, std::size_t count, Verdicts& out) {
  const Tag<T> d;
  const FilterOf<Tag<T>, has_range> filter;
  if (!run.has_many_rays) return settle<Tag<T>, false, true>(d, run.rays, run.shapes, first, count, filter, out);
  if (!run.has_many_shapes) return settle<Tag<T>, true, false>(d, run.rays, run.shapes, first, count, filter, out);
  settle<Tag<T>, true, true>(d, run.rays, run.shapes, first, count, filter, out);
}

template <template <class, bool> class FilterOf, class T, int m>
HWY_INLINE void settle_run(const Run<T, m>& run, std::size_t first, std::size_t count, Verdicts& out) {
  if (run.has_range) return settle_sides<FilterOf, true>(run, first, count, out);
  settle_sides<FilterOf, false>(run, first, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace graze::batch
HWY_AFTER_NAMESPACE();

#endif
