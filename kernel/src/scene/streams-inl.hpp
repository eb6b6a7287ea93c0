// Per target: many rays on their way through the hierarchy at once. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_STREAMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_STREAMS_INL
#undef GRAZE_SCENE_STREAMS_INL
#else
#define GRAZE_SCENE_STREAMS_INL
#endif

#include "scene/agenda-inl.hpp"
#include "scene/lanes.hpp"
#include "scene/places.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rays on their way at once: enough to hide the memory's latency, few enough for the first cache.
inline constexpr int rays_at_once = 16;
/// Of the stack of each; more is seldom, and then whole branches are visited by `walk`.
inline constexpr int stack = 24;

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
      for (Slot* slot : nodes) *keys++ = meet_children(*slot);
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
    Child leaf;             ///< that was visited last
    LaneVerdicts verdicts;  ///< of that
    Agenda<stack> agenda;
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
    slot.leaf = slot.agenda.next;
    resolve(slot, {0, 0});
  }
  HWY_INLINE void renew(Slot& slot) {
    if (slot.number < n_) batch_.finish(slot.get(), slot.number);
    slot.number = n_;
    while (given_ < n_ && !batch_.start(slot.asked, given_)) ++given_;
    if (given_ == n_) return;
    slot.number = given_++;
    slot.agenda.start(Child::node(0));
    put(slot);
  }

  HWY_INLINE const Node& node_of(const Slot& slot) const { return data_.nodes[slot.agenda.next.index()]; }
  HWY_INLINE Keys meet_children(Slot& slot) const {
    const BoxRay& ray = slot.get().visitor.box();
    return meet(RayAtBoxes<BoxLanes>(ray), ray.high, ray.is_blind, node_of(slot)).keys;
  }
  HWY_INLINE void step(Slot& slot, const Keys& keys) {
    Agenda<stack>& agenda = slot.agenda;
    if (HWY_LIKELY(!agenda.is_full())) {
      // The nearest above the top, so that what comes next is on the stack, be a child met or not.
      const auto spread = agenda.template spread<false>(keys, node_of(slot));
      agenda.child[spread.size] = spread.nearest;
      agenda.size = spread.size - (spread.is_met ? 0 : 1);
      agenda.next = agenda.child[agenda.size];
      return;
    }
    if (slot.get().visitor.run_under(agenda.next)) return agenda.stop();
    agenda.cut(slot.get().visitor.box().high);
    agenda.pop();
  }
  HWY_INLINE Slot** leave(Slot& slot, const LaneVerdicts& verdicts, Slot** end) {
    slot.verdicts = verdicts;
    *end = &slot;
    const int is_met = (verdicts.face | verdicts.uncertain) != 0 ? 1 : 0, is_missed = 1 - is_met;
    // Where it is met `resolve` goes on with this leaf.
    slot.agenda.size -= is_missed;
    slot.leaf = slot.agenda.next;
    slot.agenda.next = slot.agenda.child[slot.agenda.size];
    put(slot, is_missed);
    return end + is_met;
  }
  HWY_INLINE void resolve(Slot& slot, const LaneVerdicts& verdicts) {
    auto& visitor = slot.get().visitor;
    const float high = visitor.box().high;
    if (visitor.resolve(slot.leaf, verdicts)) {
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
