// Per target: many rays on their way through the hierarchy at once. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_STREAMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_STREAMS_INL
#undef GRAZE_SCENE_STREAMS_INL
#else
#define GRAZE_SCENE_STREAMS_INL
#endif

#include "scene/boxes-inl.hpp"
#include "scene/lanes.hpp"
#include "scene/places.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What a ray has still to visit, the nearest last; entries in a column of their own, so that eight are written at once.
struct Agenda {
  static constexpr int most = 24;  ///< more is seldom; then whole branches are visited by `walk`
  Child next, leaf;
  int size;
  alignas(32) float entry[most + width];
  alignas(32) Child child[most + width];

  void start() {
    child[0] = Child::nothing();
    size = 1;
    next = Child::node(0);
  }
  void stop() { next = Child::nothing(); }
  [[nodiscard]] bool is_full() const { return size > most; }
  HWY_INLINE void pop() { next = child[--size]; }
  /// Takes out what is entered after `high`, which has changed. Without branches: which those are is not predictable.
  void cut(float high) {
    int kept = 1;
    for (int i = 1; i < size; ++i) {
      const float at = entry[i];
      const Child one = child[i];
      entry[kept] = at;
      child[kept] = one;
      kept += at > high ? 0 : 1;
    }
    size = kept;
  }
};

/// A node's children, as one number each: where the ray enters them, the last bits of which make way for the child's number
/// (which makes it no later), or `not_met`.
struct alignas(32) Keys {
  static constexpr std::int32_t not_met = 0x7fffffff;
  std::int32_t keys[width];
};

#if HWY_MAX_BYTES >= 32

using KeyLanes = hn::CappedTag<std::int32_t, width>;

#if HWY_ARCH_X86 && HWY_MAX_BYTES < 64
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
/// As Highway's Compress, which with GCC copies its table to the stack every time.
HWY_INLINE hn::Vec<KeyLanes> compressed(hn::Vec<KeyLanes> v, hn::Mask<KeyLanes> mask) {
  const KeyLanes d;
  const hn::RebindToUnsigned<KeyLanes> bits;
  const auto lanes = hn::Shr(hn::Set(bits, lanes_of_sets[bits_of_mask(d, mask)]), hn::ShiftLeft<2>(hn::Iota(bits, 0)));
  return hn::TableLookupLanes(v, hn::IndicesFromVec(d, hn::And(lanes, hn::Set(bits, width - 1))));
}
#else
HWY_INLINE hn::Vec<KeyLanes> compressed(hn::Vec<KeyLanes> v, hn::Mask<KeyLanes> mask) {
  return hn::Compress(v, mask);
}
#endif

HWY_INLINE void meet(const BoxRay& ray, const Node& node, Keys& out) {
  const BoxLanes d;
  const hn::RebindToSigned<decltype(d)> bits;
  const auto entries = RayAtBoxes<BoxLanes>(ray).enter(node, ray.high, 0);
  const auto where = hn::And(hn::BitCast(bits, entries.first), hn::Set(bits, Keys::not_met - (width - 1)));
  const auto key = hn::Or(where, hn::Iota(bits, 0));
  hn::Store(hn::IfThenElse(hn::RebindMask(bits, entries.met), key, hn::Set(bits, Keys::not_met)), bits, out.keys);
}

/// The nearest child is next, or what was last on the agenda if none is met; the others go there.
HWY_INLINE void push(const Keys& met, const Node& node, Agenda& agenda) {
  const KeyLanes d;
  const auto keys = hn::Load(d, met.keys), nearest = hn::MinOfLanes(d, keys);
  const auto is_met = hn::Lt(keys, hn::Set(d, Keys::not_met)), is_other = hn::Gt(hn::IfThenElseZero(is_met, keys), nearest);
  const auto children = hn::Load(d, reinterpret_cast<const std::int32_t*>(node.children));
  Child* const end = agenda.child + agenda.size;
  hn::StoreU(compressed(hn::AndNot(hn::Set(d, width - 1), keys), is_other), d,
             reinterpret_cast<std::int32_t*>(agenda.entry + agenda.size));
  hn::StoreU(compressed(children, is_other), d, reinterpret_cast<std::int32_t*>(end));
  end[hn::CountTrue(d, is_other)] = node.children[static_cast<unsigned>(hn::GetLane(nearest)) % width];
  agenda.size += static_cast<int>(hn::CountTrue(d, is_met)) - 1;
  agenda.next = agenda.child[agenda.size];
}

#else

HWY_INLINE void meet(const BoxRay& ray, const Node& node, Keys& out) {
  alignas(64) float entry[width];
  const unsigned met = meet_boxes(RayAtBoxes<BoxLanes>(ray), ray.high, node, entry);
  for (int i = 0; i < width; ++i) {
    const auto key = (std::bit_cast<std::int32_t>(entry[i]) & (Keys::not_met - (width - 1))) | i;
    out.keys[i] = (met >> i & 1) != 0 ? key : Keys::not_met;
  }
}

HWY_INLINE void push(const Keys& met, const Node& node, Agenda& agenda) {
  std::int32_t nearest = Keys::not_met;
  for (const std::int32_t key : met.keys) nearest = std::min(nearest, key);
  for (int i = 0; i < width; ++i) {
    const std::int32_t key = met.keys[i];
    agenda.entry[agenda.size] = std::bit_cast<float>(key & ~(width - 1));
    agenda.child[agenda.size] = node.children[i];
    agenda.size += key != nearest && key != Keys::not_met ? 1 : 0;
  }
  if (nearest != Keys::not_met) {
    agenda.next = node.children[nearest % width];
  } else {
    agenda.pop();
  }
}

#endif

/// Rays on their way at once: enough to hide the memory's latency, few enough for the first cache.
inline constexpr int rays_at_once = 16;

/// Sends the rays of a batch on their way. Each round is a step of every ray; what a ray is to visit next is fetched meanwhile.
/// The steps go by parts, each for all rays, so that the processor has several rays in view at once, and have no branches that
/// a ray's way decides: such a branch is known so late that it would undo the work on the rays after it.
///
/// batch.start(memory, i) makes the Asked of ray i there, if it needs one; batch.finish(asked, i) has it when its way is done.
template <class Asked, Real T, class Batch>
class Streams {
 public:
  Streams(const Data<T>& data, std::size_t n, Batch& batch) : data_(data), n_(n), batch_(batch) {}

  HWY_INLINE void run() {
    if (data_.nodes.empty()) {
      for (std::size_t i = 0; i < n_; ++i) {
        if (batch_.start(slots_[0].asked, i)) batch_.finish(slots_[0].get(), i);
      }
      return;
    }
    begin_lists();
    for (Slot& slot : slots_) {
      slot.number = n_;
      renew(slot);
    }
    while (true) {
      const List nodes = list(nodes_next), triangles = list(triangles_next), others = list(others_next);
      if (nodes.empty() && triangles.empty() && others.empty()) return;
      now_ = 1 - now_;
      begin_lists();
      for (Slot* slot : others) turn_to_other(*slot);
      Keys* keys = keys_;
      for (Slot* slot : nodes) meet_children(*slot, *keys++);
      keys = keys_;
      for (Slot* slot : nodes) step(*slot, *keys++);
      for (Slot* slot : nodes) put(*slot);
      LaneVerdicts* verdicts = verdicts_;
      for (Slot* slot : triangles) *verdicts++ = slot->get().visitor.look(slot->agenda.next);
      verdicts = verdicts_;
      Slot** end = met_;
      for (Slot* slot : triangles) end = leave(*slot, *verdicts++, end);
      for (Slot** slot = met_; slot != end; ++slot) resolve(**slot, (*slot)->verdicts);
    }
  }

 private:
  struct alignas(64) Slot {
    alignas(64) std::byte asked[sizeof(Asked)];
    std::size_t number;     ///< of the ray; n for none
    LaneVerdicts verdicts;  ///< of agenda.leaf
    Agenda agenda;
    HWY_INLINE Asked& get() { return *std::launder(reinterpret_cast<Asked*>(asked)); }
  };
  /// What is next, as Child::part tells.
  enum : unsigned { nodes_next, triangles_next = 2, others_next, parts };
  using List = std::span<Slot* const>;

  HWY_INLINE List list(unsigned part) const { return List(lists_[now_][part], ends_[part]); }
  HWY_INLINE void begin_lists() {
    for (unsigned part = 0; part < parts; ++part) ends_[part] = lists_[now_][part];
  }
  /// Puts it on the list of what is next and fetches that, both without branches; but counts it not if that is not to be.
  HWY_INLINE void put(Slot& slot, int count = 1) {
    const Child next = slot.agenda.next;
    const unsigned part = next.part();
    Slot**& end = ends_[part];
    *end = &slot;
    end += count;
    places_.fetch(next);
  }

  HWY_INLINE void turn_to_other(Slot& slot) {
    if (slot.agenda.next.is_nothing()) return renew(slot);
    slot.agenda.leaf = slot.agenda.next;
    resolve(slot, {0, 0});
  }
  HWY_INLINE void renew(Slot& slot) {
    if (slot.number < n_) batch_.finish(slot.get(), slot.number);
    slot.number = n_;
    while (given_ < n_ && !batch_.start(slot.asked, given_)) ++given_;
    if (given_ == n_) return;
    slot.number = given_++;
    slot.agenda.start();
    put(slot);
  }

  HWY_INLINE const Node& node_of(const Slot& slot) const { return data_.nodes[slot.agenda.next.index()]; }
  HWY_INLINE void meet_children(Slot& slot, Keys& keys) const {
    const BoxRay& ray = slot.get().visitor.box();
    const Node& node = node_of(slot);
    meet(ray, node, keys);
    if (HWY_LIKELY(!ray.is_blind)) return;
    for (int i = 0; i < width; ++i) keys.keys[i] = node.children[i].is_nothing() ? Keys::not_met : keys.keys[i];
  }
  HWY_INLINE void step(Slot& slot, const Keys& keys) {
    if (HWY_LIKELY(!slot.agenda.is_full())) return push(keys, node_of(slot), slot.agenda);
    if (slot.get().visitor.run_under(slot.agenda.next)) return slot.agenda.stop();
    slot.agenda.cut(slot.get().visitor.box().high);
    slot.agenda.pop();
  }
  HWY_INLINE Slot** leave(Slot& slot, const LaneVerdicts& verdicts, Slot** end) {
    slot.verdicts = verdicts;
    *end = &slot;
    const int is_met = (verdicts.face | verdicts.uncertain) != 0 ? 1 : 0, is_missed = 1 - is_met;
    // Where it is met `resolve` goes on with this leaf.
    slot.agenda.size -= is_missed;
    slot.agenda.leaf = slot.agenda.next;
    slot.agenda.next = slot.agenda.child[slot.agenda.size];
    put(slot, is_missed);
    return end + is_met;
  }
  HWY_INLINE void resolve(Slot& slot, const LaneVerdicts& verdicts) {
    auto& visitor = slot.get().visitor;
    const float high = visitor.box().high;
    if (visitor.resolve(slot.agenda.leaf, verdicts)) {
      slot.agenda.stop();
    } else {
      if (visitor.box().high != high) slot.agenda.cut(visitor.box().high);
      slot.agenda.pop();
    }
    put(slot);
  }

  const Data<T>& data_;
  std::size_t n_, given_ = 0;
  Batch& batch_;
  const Places<T> places_{data_};
  unsigned now_ = 0;
  Slot* lists_[2][parts][rays_at_once + 1];
  Slot** ends_[parts];
  Keys keys_[rays_at_once];
  LaneVerdicts verdicts_[rays_at_once];
  Slot* met_[rays_at_once + 1];
  Slot slots_[rays_at_once];
};

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
