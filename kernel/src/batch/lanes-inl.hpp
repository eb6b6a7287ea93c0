// Lanes of one instruction set. Included once for each by Highway's foreach_target.
#if defined(GRAZE_BATCH_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BATCH_LANES_INL_HPP
#undef GRAZE_BATCH_LANES_INL_HPP
#else
#define GRAZE_BATCH_LANES_INL_HPP
#endif

#include <cstring>

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
HWY_INLINE std::uint64_t bits(D d, LaneMask<D> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < (hn::MaxLanes(d) + 7) / 8; ++i) out |= std::uint64_t(bytes[i]) << (8 * i);
  return out;
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

/// a b + c, in one rounding where the machine has that. The bounds hold for both.
template <class V>
HWY_INLINE V multiply_add(V a, V b, V c) {
  return hn::MulAdd(a, b, c);
}

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

  HWY_INLINE explicit Source(const Columns<T, n>& columns) : columns_(columns) {}
  HWY_INLINE Lanes<D> get(int k, std::size_t i) const { return hn::LoadU(D(), columns_.column[k] + i); }
  HWY_INLINE Vector3<D> vector(int k, std::size_t i) const { return {get(k, i), get(k + 1, i), get(k + 2, i)}; }
  HWY_INLINE void advance(std::size_t lanes) {
    for (const T*& column : columns_.column) column += column == nullptr ? 0 : lanes;
  }

 private:
  Columns<T, n> columns_;
};

template <class D, int n>
class Source<D, n, false> {
 public:
  using T = hn::TFromD<D>;

  HWY_INLINE explicit Source(const Columns<T, n>& columns) {
    for (int k = 0; k < n; ++k) spread_[k] = columns.column[k] == nullptr ? hn::Zero(D()) : hn::Set(D(), *columns.column[k]);
  }
  HWY_INLINE Lanes<D> get(int k, std::size_t) const { return spread_[k]; }
  HWY_INLINE Vector3<D> vector(int k, std::size_t i) const { return {get(k, i), get(k + 1, i), get(k + 2, i)}; }
  HWY_INLINE void advance(std::size_t) {}

 private:
  Lanes<D> spread_[n];
};

/// The last lanes, fewer than a vector: copied, so that nothing past the ends is read.
template <class D, int n, bool many>
class Tail {
 public:
  using T = hn::TFromD<D>;

  HWY_INLINE Tail(const Columns<T, n>& columns, std::size_t first, std::size_t count) : columns_(columns) {
    if constexpr (many) {
      for (int k = 0; k < n; ++k) {
        if (columns.column[k] == nullptr) continue;
        std::memset(buffer_[k], 0, sizeof buffer_[k]);
        std::memcpy(buffer_[k], columns.column[k] + first, count * sizeof(T));
        columns_.column[k] = buffer_[k];
      }
    }
  }
  HWY_INLINE Source<D, n, many> source() const { return Source<D, n, many>(columns_); }

 private:
  Columns<T, n> columns_;
  T buffer_[many ? n : 1][16];
};

/// What a filter tells of one vector, as bits.
struct VectorVerdict {
  std::uint64_t hit, settled, side;
};

/// The same of up to 64 lanes.
struct WordVerdict {
  std::uint64_t hit = 0, settled = 0, side = 0;

  HWY_INLINE void include(const VectorVerdict& v, std::size_t lane) {
    hit |= v.hit << lane;
    settled |= v.settled << lane;
    side |= v.side << lane;
  }
};

/// Calls filter(rays, shapes, i) for vectors of the lanes from `first`, and gathers its verdicts in words.
template <class D, bool many_rays, bool many_shapes, int n, int m, class Filter>
HWY_INLINE void settle(D d, const Columns<hn::TFromD<D>, n>& ray_columns, const Columns<hn::TFromD<D>, m>& shape_columns,
                       std::size_t first, std::size_t count, const Filter& filter, Verdicts& out) {
  const std::size_t step = hn::Lanes(d);
  Source<D, n, many_rays> rays(ray_columns);
  Source<D, m, many_shapes> shapes(shape_columns);
  rays.advance(first);
  shapes.advance(first);
  for (std::size_t word = 0; 64 * word < count; ++word, rays.advance(64), shapes.advance(64)) {
    WordVerdict gathered;
    const std::size_t left = count - 64 * word;
    if (left >= 64) {
      // Four vectors at constant offsets: their loads need no index, and no load waits for another's vector.
      for (std::size_t lane = 0; lane < 64; lane += 4 * step) {
        gathered.include(filter(rays, shapes, lane), lane);
        gathered.include(filter(rays, shapes, lane + step), lane + step);
        gathered.include(filter(rays, shapes, lane + 2 * step), lane + 2 * step);
        gathered.include(filter(rays, shapes, lane + 3 * step), lane + 3 * step);
      }
    } else {
      std::size_t lane = 0;
      for (; lane + step <= left; lane += step) gathered.include(filter(rays, shapes, lane), lane);
      if (lane < left) {
        const std::size_t at = first + 64 * word + lane;
        const Tail<D, n, many_rays> last_rays(ray_columns, at, left - lane);
        const Tail<D, m, many_shapes> last_shapes(shape_columns, at, left - lane);
        gathered.include(filter(last_rays.source(), last_shapes.source(), 0), lane);
      }
    }
    out.hit[word] = gathered.hit;
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
