// Per target: what closest, any, count and collect do with a hit. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_VISITORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_VISITORS_INL
#undef GRAZE_SCENE_VISITORS_INL
#else
#define GRAZE_SCENE_VISITORS_INL
#endif

#include <utility>

#include "scene/hit_visitor-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

template <class T, class Tally>
struct AnyVisitor : HitVisitor<T, Tally, AnyVisitor<T, Tally>> {
  HWY_INLINE AnyVisitor(const Query<T, Tally>& query, bool is_plain) : HitVisitor<T, Tally, AnyVisitor>(query, is_plain) {}
  static constexpr bool wants_t = false;
  bool is_hit = false;
  Candidate one;
  Candidate& space() { return one; }
  bool hit(const Candidate&) { return is_hit = true; }
  bool hits(unsigned) { return is_hit = true; }
};

template <class T, class Tally>
struct CountVisitor : HitVisitor<T, Tally, CountVisitor<T, Tally>> {
  HWY_INLINE CountVisitor(const Query<T, Tally>& query, bool is_plain) : HitVisitor<T, Tally, CountVisitor>(query, is_plain) {}
  static constexpr bool wants_t = false;
  std::uint64_t sum = 0;
  Candidate one;
  Candidate& space() { return one; }
  bool hit(const Candidate& found) { return hits(this->is_counted_here(found) ? 1 : 0); }
  bool hits(unsigned n) {
    sum += n;
    return false;
  }
};

/// As comes_before. Not inlined: few enclosures overlap.
template <Real T, class Tally>
HWY_NOINLINE HWY_FLATTEN bool overlapping_comes_before(const Query<T, Tally>& query, const Candidate& one,
                                                       const Candidate& other) {
  return comes_before(query, one, other);
}

template <class T, class Tally>
struct ClosestVisitor : HitVisitor<T, Tally, ClosestVisitor<T, Tally>> {
  HWY_INLINE ClosestVisitor(const Query<T, Tally>& query, bool is_plain)
      : HitVisitor<T, Tally, ClosestVisitor<T, Tally>>(query, is_plain) {}
  ClosestVisitor(const ClosestVisitor&) = delete;
  ClosestVisitor& operator=(const ClosestVisitor&) = delete;
  static constexpr bool wants_t = true;
  [[nodiscard]] const Candidate& best() const { return *best_; }
  Candidate& space() { return *next_; }
  bool hits(unsigned) { return false; }
  bool hit(Candidate& found) {
    const Candidate& best = *best_;
    if (best.shape != Shape::none) {
      if (found.index == best.index || found.t.low > best.t.high) return false;
      if (!(found.t.high < best.t.low)) {
        if (!overlapping_comes_before(this->query_, found, best)) return false;
        // What comes first is not after the other's upper bound either.
        found.t.high = std::min(found.t.high, best.t.high);
      }
    }
    std::swap(best_, next_);
    this->end_at(found.t.high);
    return false;
  }

 private:
  Candidate candidates_[2];
  Candidate *best_ = &candidates_[0], *next_ = &candidates_[1];
};

template <Real T, class Tally>
struct CollectVisitor : HitVisitor<T, Tally, CollectVisitor<T, Tally>> {
  HWY_INLINE CollectVisitor(const Query<T, Tally>& query, bool is_plain, bool only, std::vector<Candidate>& all)
      : HitVisitor<T, Tally, CollectVisitor>(query, is_plain), only_closest(only), found(all) {}
  static constexpr bool wants_t = true;
  bool only_closest;
  std::vector<Candidate>& found;
  Candidate one;
  Candidate& space() { return one; }
  bool hits(unsigned) { return false; }
  bool hit(const Candidate& candidate) {
    if (candidate.t.low > this->end_) return false;
    // Where the ray is shortened on its way, repeats are for the caller to drop.
    if (!only_closest && !this->is_counted_here(candidate)) return false;
    found.push_back(candidate);
    if (only_closest && candidate.t.high < this->end_) {
      this->end_at(candidate.t.high);
    }
    return false;
  }
};

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
