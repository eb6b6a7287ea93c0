// The hot loops, compiled for each of Highway's targets: this file and the -inl files are included again for each.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/kernels.cpp"
// clang-format off: the first must come before all, the last after all.
#include "scene/kernels.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <limits>
#include <new>

#include "exact/parity.hpp"
#include "graze/implicit.hpp"
#include "rounding/quotients.hpp"
#include "scene/boxes-inl.hpp"
#include "scene/face-inl.hpp"
#include "scene/home-inl.hpp"
#include "scene/lanes.hpp"
#include "scene/triangles-inl.hpp"
#include "scene/walk-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// The headers' own functions are compiled for the baseline: called from here, each would pay for the change of registers'
/// width. Flattened they are compiled for the target.
template <Real T>
struct Rays {
  RayLanes<T> lanes;
  BoxRay box;
};
template <Real T>
HWY_NOINLINE HWY_FLATTEN Rays<T> rays_of(const Data<T>& data, const Ray<T>& ray) {
  return {RayLanes<T>(ray, data.extent), box_ray(data.space, data.root, ray)};
}
template <Real T>
HWY_NOINLINE HWY_FLATTEN void end_rays_at(RayLanes<T>& lanes, BoxRay& box, double t) {
  lanes.end_at(t);
  box.end_at(t);
}

/// Visits leaves; Derived::hit(candidate) is told of each shape that the ray meets and the query takes, and returns true to end
/// the walk. Its `end` is the parameter beyond which it does not care, where it has one.
template <Real T, class Tally, class Derived>
class HitVisitor {
 public:
  explicit HitVisitor(const Query<T, Tally>& query)
      : query_(query), rays_(rays_of(query.data, query.ray)), takes_all_(query.takes_all()) {}

  HWY_INLINE void run() { walk(query_, box_, *this); }

  HWY_INLINE bool leaf(Child child) {
    return child.is_spheres() ? spheres(query_.data.spheres[child.index()], child.index())
                              : triangles(query_.data.triangles[child.index()], child.index());
  }

 protected:
  const Query<T, Tally>& query_;
  /// Hits beyond t do not matter any more.
  HWY_INLINE void end_at(double t) {
    end_ = t;
    end_rays_at(ray_, box_, t);
  }

  /// Of a triangle in several leaves, whether this is the one to count it.
  [[nodiscard]] HWY_INLINE bool is_counted_here(const Candidate& found) const {
    return HWY_LIKELY(query_.data.listings.empty()) || is_home(query_.data, box_, found.index, found.block);
  }

  Rays<T> rays_;
  RayLanes<T>& ray_ = rays_.lanes;
  BoxRay& box_ = rays_.box;
  double end_ = std::numeric_limits<double>::infinity();
  bool takes_all_;

 private:
  Derived& self() { return static_cast<Derived&>(*this); }

  HWY_INLINE bool triangles(const TriangleBlock<T>& block, std::uint32_t number) {
    const unsigned lanes = lanes_of(block.index);
    const auto tests = static_cast<unsigned>(__builtin_popcount(lanes));
    query_.tally.template add<&Statistics::triangle_tests>(tests);
    if (HWY_UNLIKELY(ray_.is_integer)) return integers(block, number, lanes);
    LaneVerdicts verdicts{0, lanes};
    if (HWY_LIKELY(ray_.range_is_plain)) {
      verdicts = settle(ray_, block);
      verdicts.face &= lanes;
      verdicts.uncertain &= lanes;
      query_.tally.template add<&Statistics::error_bounds>(tests);
    }
    unsigned rest = verdicts.face | verdicts.uncertain;
    query_.tally.template add<&Statistics::filter_misses>(tests - __builtin_popcount(rest));
    if (!Derived::wants_t && takes_all_ && verdicts.face != 0) {
      const auto faces = static_cast<unsigned>(__builtin_popcount(verdicts.face));
      query_.tally.template add<&Statistics::filter_hits>(faces);
      if (self().hits(faces)) return true;
      rest = verdicts.uncertain;
    }
    for (; rest != 0; rest &= rest - 1) {
      if (triangle(block, number, __builtin_ctz(rest))) return true;
    }
    return false;
  }

  /// One that the lanes have not rejected, again in double, and then exactly. Not inlined: few come here.
  HWY_NOINLINE HWY_FLATTEN bool triangle(const TriangleBlock<T>& block, std::uint32_t number, int i) {
    using predicates::TriangleVerdict;
    if (!query_.sees(block.index[i])) return false;
    const Triangle<T> triangle = block.triangle(i);
    Candidate found = candidate(block, number, i);
    found.terms = predicates::triangle_terms<double>(query_.ray, triangle);
    const TriangleVerdict verdict = predicates::verdict(found.terms, query_.ray);
    if (verdict == TriangleVerdict::miss) {
      query_.tally.template add<&Statistics::filter_misses>(1);
      return false;
    }
    // Where ray and plane meet, which is the hit, if there is one.
    const bool is_bounded = found.terms.are_bounded && found.terms.whole > found.terms.error;
    if (Derived::wants_t && is_bounded) found.t = enclose(found.terms);
    found.is_face = verdict == TriangleVerdict::face;
    if (found.is_face) {
      query_.tally.template add<&Statistics::filter_hits>(1);
      if (!query_.takes(TriangleKind::face, found.terms.is_front ? Facing::front : Facing::back)) return false;
    } else {
      if (Derived::wants_t && is_bounded && found.t.low > end_) {
        query_.tally.template add<&Statistics::filter_misses>(1);
        return false;
      }
      if (!decide(triangle)) return false;
      if (Derived::wants_t && !is_bounded) found.t = exact::enclose_first(query_.ray, triangle);
    }
    return self().hit(found);
  }

  /// All of a block, where their determinants are exact: only rays in a triangle's plane are left to the exact stage.
  HWY_NOINLINE HWY_FLATTEN bool integers(const TriangleBlock<T>& block, std::uint32_t number, unsigned lanes) {
    IntegerVerdicts verdicts;
    settle_integers(query_.ray, block, verdicts);
    unsigned met = verdicts.met & lanes;
    const unsigned uncertain = verdicts.uncertain & lanes;
    query_.tally.template add<&Statistics::filter_misses>(__builtin_popcount(lanes & ~(met | uncertain)));
    if (!Derived::wants_t && takes_all_ && met != 0) {
      const auto hits = static_cast<unsigned>(__builtin_popcount(met));
      query_.tally.template add<&Statistics::filter_hits>(hits);
      if (self().hits(hits)) return true;
      met = 0;
    }
    for (unsigned rest = met | uncertain; rest != 0; rest &= rest - 1) {
      const int i = __builtin_ctz(rest);
      const auto bit = [i](unsigned bits) { return (bits >> i & 1) != 0; };
      if (!query_.sees(block.index[i])) continue;
      Candidate found = candidate(block, number, i);
      if (bit(met)) {
        query_.tally.template add<&Statistics::filter_hits>(1);
        // Of a point in the plane options see only the side.
        if (!query_.takes(TriangleKind::face, bit(verdicts.front) ? Facing::front : Facing::back)) continue;
        const double whole = verdicts.whole[i], u = verdicts.u[i], v = verdicts.v[i], distance = verdicts.distance[i];
        found.is_face = bit(verdicts.inner);
        found.is_integer = true;
        found.terms = {whole, u, v, whole - u - v, distance, 0, 0, bit(verdicts.front), true};
        if (Derived::wants_t) found.t = enclose(found.terms);
      } else {
        const Triangle<T> triangle = block.triangle(i);
        if (!decide(triangle)) continue;
        if (Derived::wants_t) found.t = exact::enclose_first(query_.ray, triangle);
      }
      if (self().hit(found)) return true;
    }
    return false;
  }

  [[nodiscard]] HWY_INLINE Candidate candidate(const TriangleBlock<T>& block, std::uint32_t number, int i) const {
    Candidate found;
    found.shape = Shape::triangle;
    found.lane = static_cast<std::uint8_t>(i);
    found.block = number;
    found.index = block.index[i];
    return found;
  }

  /// By exact integers: whether the ray meets the triangle and the query takes it.
  [[nodiscard]] bool decide(const Triangle<T>& triangle) const {
    query_.tally.template add<&Statistics::exact_decisions>(1);
    const exact::TriangleDecision decision = exact::decide(query_.ray, triangle);
    return decision.kind != TriangleKind::miss && query_.takes(decision.kind, decision.facing);
  }

  HWY_NOINLINE HWY_FLATTEN bool spheres(const SphereBlock<T>& block, std::uint32_t number) {
    for (int i = 0; i < width && block.index[i] != no_primitive; ++i) {
      query_.tally.template add<&Statistics::sphere_tests>(1);
      const Sphere<T> sphere = block.sphere(i);
      predicates::SphereTerms<double> terms = predicates::sphere_terms<double>(query_.ray, sphere);
      const predicates::SphereVerdict verdict = predicates::verdict(terms, query_.ray, sphere);
      query_.tally.template add<&Statistics::error_bounds>(1);
      if (verdict.kind == SphereKind::miss) {
        query_.tally.template add<&Statistics::filter_misses>(1);
        continue;
      }
      if (!query_.sees(block.index[i])) continue;
      const bool is_certain = verdict.kind == SphereKind::secant;
      if (is_certain) {
        query_.tally.template add<&Statistics::filter_hits>(1);
      } else {
        query_.tally.template add<&Statistics::exact_decisions>(1);
        if (!exact::hits(query_.ray, sphere)) continue;
      }
      Candidate found;
      found.shape = Shape::sphere;
      found.lane = static_cast<std::uint8_t>(i);
      found.block = number;
      found.index = block.index[i];
      if (Derived::wants_t) {
        found.t = is_certain ? enclose(query_.ray, sphere, terms, verdict) : exact::enclose_first(query_.ray, sphere);
      }
      if (self().hit(found)) return true;
    }
    return false;
  }
};

template <Real T, class Tally>
struct AnyVisitor : HitVisitor<T, Tally, AnyVisitor<T, Tally>> {
  using HitVisitor<T, Tally, AnyVisitor>::HitVisitor;
  static constexpr bool wants_t = false;
  bool is_hit = false;
  bool hit(const Candidate&) { return is_hit = true; }
  bool hits(unsigned) { return is_hit = true; }
};

template <Real T, class Tally>
struct CountVisitor : HitVisitor<T, Tally, CountVisitor<T, Tally>> {
  using HitVisitor<T, Tally, CountVisitor>::HitVisitor;
  static constexpr bool wants_t = false;
  std::uint64_t sum = 0;
  bool hit(const Candidate& found) {
    const bool is_counted = found.shape == Shape::sphere || this->is_counted_here(found);
    return hits(is_counted ? 1 : 0);
  }
  bool hits(unsigned n) {
    sum += n;
    return false;
  }
};

template <Real T, class Tally>
struct ClosestVisitor : HitVisitor<T, Tally, ClosestVisitor<T, Tally>> {
  ClosestVisitor(const Query<T, Tally>& query, Candidate& closest)
      : HitVisitor<T, Tally, ClosestVisitor>(query), best(closest) {}
  static constexpr bool wants_t = true;
  Candidate& best;
  bool hits(unsigned) { return false; }
  bool hit(Candidate& found) {
    if (best.shape != Shape::none) {
      if (found.index == best.index) return false;
      if (!comes_before(this->query_, found, best)) return false;
      // What comes first is not after the other's upper bound either.
      found.t.high = std::min(found.t.high, best.t.high);
    }
    best = found;
    this->end_at(best.t.high);
    return false;
  }
};

template <Real T, class Tally>
struct CollectVisitor : HitVisitor<T, Tally, CollectVisitor<T, Tally>> {
  CollectVisitor(const Query<T, Tally>& query, bool only, std::vector<Candidate>& all)
      : HitVisitor<T, Tally, CollectVisitor>(query), only_closest(only), found(all) {}
  static constexpr bool wants_t = true;
  bool only_closest;
  std::vector<Candidate>& found;
  bool hits(unsigned) { return false; }
  bool hit(const Candidate& candidate) {
    if (candidate.t.low > this->end_) return false;
    // Where the ray is shortened on its way, repeats are for the caller to drop.
    if (!only_closest && candidate.shape == Shape::triangle && !this->is_counted_here(candidate)) return false;
    found.push_back(candidate);
    if (only_closest && candidate.t.high < this->end_) {
      this->end_at(candidate.t.high);
    }
    return false;
  }
};

/// Counts the crossings of the way out from the ray's origin along +x. A primitive that the point is on, or a sphere that holds
/// it, is met by that ray too, so its leaf is visited.
template <Real T, class Tally>
class InsideVisitor {
 public:
  explicit InsideVisitor(const Query<T, Tally>& query) : query_(query), rays_(rays_of(query.data, query.ray)) {}

  [[nodiscard]] HWY_INLINE Place place() {
    walk(query_, box_, *this);
    return is_on_ ? Place::boundary : is_inside_ ? Place::inside : Place::outside;
  }

  HWY_INLINE bool leaf(Child child) {
    return child.is_spheres() ? spheres(query_.data.spheres[child.index()])
                              : triangles(query_.data.triangles[child.index()], child.index());
  }

 private:
  HWY_INLINE bool triangles(const TriangleBlock<T>& block, std::uint32_t number) {
    using predicates::TriangleVerdict;
    const unsigned lanes = lanes_of(block.index);
    const auto tests = static_cast<unsigned>(__builtin_popcount(lanes));
    query_.tally.template add<&Statistics::triangle_tests>(tests);
    // A certain verdict holds for the perturbed ray too, and for the point itself: it is an end of the ray.
    LaneVerdicts verdicts;
    if (ray_.is_integer) {
      IntegerVerdicts exact_ones;
      settle_integers(query_.ray, block, exact_ones);
      verdicts = {exact_ones.inner, (exact_ones.met & ~exact_ones.inner) | exact_ones.uncertain};
    } else {
      query_.tally.template add<&Statistics::error_bounds>(tests);
      verdicts = settle(ray_, block);
    }
    verdicts.face = at_home(query_.data, box_, block, number, verdicts.face & lanes);
    verdicts.uncertain = at_home(query_.data, box_, block, number, verdicts.uncertain & lanes);
    is_inside_ ^= (__builtin_popcount(verdicts.face) & 1) != 0;
    for (unsigned rest = verdicts.uncertain; rest != 0; rest &= rest - 1) {
      const Triangle<T> triangle = block.triangle(__builtin_ctz(rest));
      if (!ray_.is_integer) {
        const TriangleVerdict verdict =
            predicates::verdict(predicates::triangle_terms<double>(query_.ray, triangle), query_.ray);
        if (verdict != TriangleVerdict::uncertain) {
          is_inside_ ^= verdict == TriangleVerdict::face;
          continue;
        }
      }
      query_.tally.template add<&Statistics::exact_decisions>(1);
      if (exact::is_on(query_.ray.origin, triangle)) return is_on_ = true;
      is_inside_ ^= exact::is_crossed(query_.ray.origin, triangle);
    }
    return false;
  }

  HWY_NOINLINE HWY_FLATTEN bool spheres(const SphereBlock<T>& block) {
    for (int i = 0; i < width && block.index[i] != no_primitive && !is_on_; ++i) {
      query_.tally.template add<&Statistics::sphere_tests>(1);
      const Sign sign = side(query_.ray.origin, block.sphere(i)).sign;
      is_on_ = sign == Sign::zero;
      is_inside_ ^= sign == Sign::negative;
    }
    return is_on_;
  }

  const Query<T, Tally>& query_;
  Rays<T> rays_;
  RayLanes<T>& ray_ = rays_.lanes;
  BoxRay& box_ = rays_.box;
  bool is_inside_ = false, is_on_ = false;
};

template <Real T, class Tally>
void closest(const Query<T, Tally>& query, Candidate& best) noexcept {
  ClosestVisitor<T, Tally>(query, best).run();
}
template <Real T, class Tally>
bool any(const Query<T, Tally>& query) noexcept {
  AnyVisitor<T, Tally> visitor(query);
  visitor.run();
  return visitor.is_hit;
}
template <Real T, class Tally>
std::uint64_t count(const Query<T, Tally>& query) noexcept {
  CountVisitor<T, Tally> visitor(query);
  visitor.run();
  return visitor.sum;
}
template <Real T, class Tally>
void collect(const Query<T, Tally>& query, bool only_closest, std::vector<Candidate>& found) {
  CollectVisitor<T, Tally>(query, only_closest, found).run();
}
template <Real T, class Tally>
Place inside(const Query<T, Tally>& query) noexcept {
  return InsideVisitor<T, Tally>(query).place();
}

unsigned children_met(const BoxRay& ray, const Node& node, float* entry) noexcept {
  alignas(64) float at[width];
  const unsigned met = meet_boxes(ray, node, at);
  for (int i = 0; i < width; ++i) entry[i] = at[i];
  return met;
}

template <Real T, class Tally>
constexpr QueryKernels<T, Tally> query_kernels{closest<T, Tally>, any<T, Tally>, count<T, Tally>, collect<T, Tally>,
                                               inside<T, Tally>};

const Kernels& target_kernels() {
  static constexpr Kernels table{query_kernels<float, Silent>,
                                 query_kernels<float, Counting>,
                                 query_kernels<double, Silent>,
                                 query_kernels<double, Counting>,
                                 face,
                                 children_met};
  return table;
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::scene {

HWY_EXPORT(target_kernels);

const Kernels& kernels() noexcept {
  return HWY_DYNAMIC_DISPATCH(target_kernels)();
}

}  // namespace graze::scene
#endif
