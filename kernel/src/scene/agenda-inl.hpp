// Per target: what a ray has still to visit. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_AGENDA_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_AGENDA_INL
#undef GRAZE_SCENE_AGENDA_INL
#else
#define GRAZE_SCENE_AGENDA_INL
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "scene/boxes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using KeyLanes = hn::RebindToSigned<BoxLanes>;
inline constexpr int key_lanes = static_cast<int>(hn::MaxLanes(BoxLanes()));

HWY_INLINE hn::Vec<KeyLanes> load_children(const Child* from) {
  return hn::LoadU(KeyLanes(), reinterpret_cast<const std::int32_t*>(from));
}
HWY_INLINE void store_children(hn::Vec<KeyLanes> children, Child* to) {
  hn::StoreU(children, KeyLanes(), reinterpret_cast<std::int32_t*>(to));
}

/// A node's children, as one number each: where the ray enters them, the last bits of which make way for the child's number
/// (which makes it no later), or `not_met`.
struct Keys {
  static constexpr std::int32_t not_met = 0x7fffffff;
  static constexpr int parts = width / key_lanes;
  /// Not initialised; GCC compiles what is implicit for the baseline.
  HWY_INLINE Keys() {}
  hn::Vec<KeyLanes> part[parts];
};
/// The least of all, in every lane.
HWY_INLINE hn::Vec<KeyLanes> least_of(const Keys& keys) {
  auto least = keys.part[0];
  for (int p = 1; p < Keys::parts; ++p) least = hn::Min(least, keys.part[p]);
  return hn::MinOfLanes(KeyLanes(), least);
}
/// Without the one of this number, as if it were not met.
HWY_INLINE Keys without(Keys keys, hn::Vec<KeyLanes> one) {
  const auto none = hn::Set(KeyLanes(), Keys::not_met);
  for (auto& part : keys.part) part = hn::IfThenElse(hn::Eq(part, one), none, part);
  return keys;
}

/// Of a node the children whose boxes the ray meets; of a blind ray's all that are something.
struct Met {
  Keys keys;
  bool is_any;  ///< as the least key tells too, but sooner
};
HWY_INLINE Met meet(const RayAtBoxes<BoxLanes>& ray, float high, bool is_blind, const Node& node) {
  const KeyLanes d;
  Keys keys;
  auto any = hn::MaskFromVec(hn::Zero(d));
  for (int p = 0; p < Keys::parts; ++p) {
    const int i = p * key_lanes;
    const auto entries = ray.enter(node, high, static_cast<std::size_t>(i));
    auto met = hn::RebindMask(d, entries.met);
    if (HWY_UNLIKELY(is_blind)) met = hn::And(met, hn::Ne(load_children(node.children + i), hn::Set(d, -1)));
    const auto where = hn::And(hn::BitCast(d, entries.first), hn::Set(d, Keys::not_met - (width - 1)));
    keys.part[p] = hn::IfThenElse(met, hn::Or(where, hn::Iota(d, i)), hn::Set(d, Keys::not_met));
    any = hn::Or(any, met);
  }
  return {keys, !hn::AllFalse(d, any)};
}

#if HWY_ARCH_X86 && HWY_MAX_BYTES == 32
/// Of each set of lanes, in four bits each from the lowest on, which they are, in order.
inline constexpr auto lanes_of_sets = [] {
  std::array<std::uint32_t, 1U << width> out{};
  for (unsigned set = 0; set < out.size(); ++set) {
    int n = 0;
    for (unsigned lane = 0; lane < width; ++lane) {
      if ((set >> lane & 1) != 0) out[set] |= lane << (4 * n++);
    }
  }
  return out;
}();
/// How to put a vector's chosen lanes first, in order; as Highway's Compress, which with GCC copies its table to the stack
/// every time.
HWY_INLINE auto order_of(hn::Mask<KeyLanes> chosen) {
  const KeyLanes d;
  const hn::RebindToUnsigned<KeyLanes> bits;
  const auto lanes = hn::Shr(hn::Set(bits, lanes_of_sets[bits_of_mask(d, chosen)]), hn::ShiftLeft<2>(hn::Iota(bits, 0)));
  return hn::IndicesFromVec(d, hn::And(lanes, hn::Set(bits, width - 1)));
}
template <class Order>
HWY_INLINE hn::Vec<KeyLanes> compressed(hn::Vec<KeyLanes> v, Order order) {
  return hn::TableLookupLanes(v, order);
}
#else
HWY_INLINE hn::Mask<KeyLanes> order_of(hn::Mask<KeyLanes> chosen) {
  return chosen;
}
HWY_INLINE hn::Vec<KeyLanes> compressed(hn::Vec<KeyLanes> v, hn::Mask<KeyLanes> chosen) {
  return hn::Compress(v, chosen);
}
#endif

/// What a ray has still to visit: what comes next, and a stack of the rest, to which a node's children are added while it holds
/// at most so many. Entries are a column of their own, so that a vector of them is written at once. Of a node's children the
/// nearest comes next, and the second after what that leads to, where that matters; the others are in no order, for there are
/// few. Nothing here branches on which children are met or how many, which is not predictable.
template <int most>
struct Agenda {
  Child next;
  int size;  ///< of the stack, the lowest of which is nothing
  // A vector more than what the last node puts there, for vectors are written whole.
  alignas(32) float entry[most + 2 * width];
  alignas(32) Child child[most + 2 * width];

  HWY_INLINE void start(Child first) {
    child[0] = Child::nothing();
    size = 1;
    next = first;
  }
  [[nodiscard]] bool is_full() const { return size > most; }
  HWY_INLINE void stop() { next = Child::nothing(); }
  HWY_INLINE void pop() { next = child[--size]; }

  /// The nearest child, if one is met, and the size of the stack with the others on it.
  struct Spread {
    Child nearest;
    bool is_met;
    int size;
  };
  /// Puts all children that are met on the stack but the nearest; its size is for the caller to set. `in_order`: the second
  /// nearest on top.
  template <bool in_order>
  HWY_INLINE Spread spread(const Keys& keys, const Node& node) {
    const KeyLanes d;
    const auto none = hn::Set(d, Keys::not_met), numbers = hn::Set(d, width - 1);
    const auto nearest = least_of(keys);
    Keys others = without(keys, nearest);
    auto second = none;
    if constexpr (in_order) {
      second = least_of(others);
      others = without(others, second);
    }
    int end = size;
    for (int p = 0; p < Keys::parts; ++p) {
      const auto is_other = hn::Lt(others.part[p], none);
      const auto order = order_of(is_other);
      hn::StoreU(hn::BitCast(BoxLanes(), compressed(hn::AndNot(numbers, others.part[p]), order)), BoxLanes(), entry + end);
      store_children(compressed(load_children(node.children + p * key_lanes), order), child + end);
      end += static_cast<int>(hn::CountTrue(d, is_other));
    }
    if constexpr (in_order) {
      const std::int32_t key = hn::GetLane(second);
      entry[end] = std::bit_cast<float>(key & ~(width - 1));
      child[end] = node.children[static_cast<unsigned>(key) % width];
      end += key != Keys::not_met ? 1 : 0;
    }
    const std::int32_t nearest_key = hn::GetLane(nearest);
    const bool is_met = nearest_key != Keys::not_met;
    if constexpr (Keys::parts == 1) {
      // Within the vectors, which is sooner known than by way of memory.
      const auto lane = hn::IndicesFromVec(d, hn::And(nearest, numbers));
      return {Child::from_bits(hn::GetLane(hn::TableLookupLanes(load_children(node.children), lane))), is_met, end};
    } else {
      return {node.children[static_cast<unsigned>(nearest_key) % width], is_met, end};
    }
  }
  /// Takes out what is entered after `high`.
  HWY_INLINE void cut(float high) {
    const BoxLanes d;
    int kept = 1;
    for (int i = 1; i < size; i += key_lanes) {
      const auto at = hn::LoadU(d, entry + i);
      const auto some = hn::FirstN(d, static_cast<std::size_t>(std::min(size - i, key_lanes)));
      const auto stays = hn::And(hn::Le(at, hn::Set(d, high)), some);
      const auto order = order_of(hn::RebindMask(KeyLanes(), stays));
      const auto children = compressed(load_children(child + i), order);
      hn::StoreU(hn::BitCast(d, compressed(hn::BitCast(KeyLanes(), at), order)), d, entry + kept);
      store_children(children, child + kept);
      kept += static_cast<int>(hn::CountTrue(d, stays));
    }
    size = kept;
  }
};

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
