// Per target: what every query for hits does with a leaf. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_HIT_VISITOR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_HIT_VISITOR_INL
#undef GRAZE_SCENE_HIT_VISITOR_INL
#else
#define GRAZE_SCENE_HIT_VISITOR_INL
#endif

#include "scene/home-inl.hpp"
#include "scene/query.hpp"
#include "scene/rays-inl.hpp"
#include "scene/triangles-inl.hpp"
#include "scene/walk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Visits leaves; Derived::hit(candidate) is told of each shape that the ray meets and the query takes, and returns true to end
/// the walk. Its `end` is the parameter beyond which it does not care, where it has one.
template <Real T, class Tally, class Derived>
class HitVisitor {
 public:
  /// `is_plain` tells of the ray, which is valid. (GCC compiles inherited constructors for the baseline.)
  HWY_INLINE HitVisitor(const Query<T, Tally>& query, bool is_plain)
      : query_(query),
        blocks_(query.data.triangles.data()),
        rays_(query.data, query.ray, is_plain),
        takes_all_(query.takes_all()) {}

  HWY_INLINE void run() { walk<Derived::wants_t>(query_, rays_.box, *this, Child::node(0)); }
  /// Visits the leaves under a node; returns true to end the walk.
  HWY_NOINLINE bool run_under(Child node) { return walk<Derived::wants_t>(query_, rays_.box, *this, node); }
  HWY_INLINE const BoxRay& box() const { return rays_.box; }

  /// Not inlined: the way through the nodes shall have the registers.
  HWY_NOINLINE bool leaf(Child child) {
    const LaneVerdicts verdicts = look(child);
    return (verdicts.face | verdicts.uncertain) != 0 && resolve(child, verdicts);
  }
  /// What the filter says of a leaf's lanes: for `resolve`, if not all are missed. Where there is no filter all are uncertain.
  HWY_INLINE LaneVerdicts look(Child child) {
    if (HWY_UNLIKELY(child.is_spheres())) return {0, 1};
    const TriangleBlock<T>& block = blocks_[child.index()];
    const unsigned lanes = lanes_of(block.index);
    const auto tests = static_cast<unsigned>(__builtin_popcount(lanes));
    query_.tally.template add<&Statistics::triangle_tests>(tests);
    if (HWY_UNLIKELY(rays_.lanes.is_integer)) return {0, lanes};
    LaneVerdicts verdicts{0, lanes};
    if (HWY_LIKELY(rays_.lanes.range_is_plain)) {
      if constexpr (Derived::wants_t) {
        verdicts = settle(rays_.lanes, block, terms_);
      } else {
        verdicts = settle(rays_.lanes, block);
      }
      verdicts.face &= lanes;
      verdicts.uncertain &= lanes;
      query_.tally.template add<&Statistics::error_bounds>(tests);
    }
    query_.tally.template add<&Statistics::filter_misses>(tests - __builtin_popcount(verdicts.face | verdicts.uncertain));
    return verdicts;
  }
  /// Returns true to end the walk.
  HWY_INLINE bool resolve(Child child, const LaneVerdicts& verdicts) {
    return HWY_UNLIKELY(child.is_spheres()) ? spheres(query_.data.spheres[child.index()], child.index())
                                            : triangles(blocks_[child.index()], child.index(), verdicts);
  }

 protected:
  const Query<T, Tally>& query_;
  const TriangleBlock<T>* blocks_;  ///< the data's: known early, though nobody knows which is next
  /// Hits beyond t do not matter any more.
  HWY_INLINE void end_at(double t) {
    end_ = t;
    rays_.lanes.end_at(t);
    rays_.box.end_at(t);
  }

  /// Of a triangle in several leaves, whether this is the one to count it.
  [[nodiscard]] HWY_INLINE bool is_counted_here(const Candidate& found) const {
    return found.shape == Shape::sphere || is_home(query_.data, rays_.box, found.index, found.block);
  }

  Rays<T> rays_;
  LaneTerms<T> terms_;  ///< of the leaf that was looked at last, where t is wanted
  double end_ = std::numeric_limits<double>::infinity();
  bool takes_all_;

 private:
  Derived& self() { return static_cast<Derived&>(*this); }

  HWY_INLINE bool triangles(const TriangleBlock<T>& block, std::uint32_t number, const LaneVerdicts& verdicts) {
    unsigned rest = verdicts.face | verdicts.uncertain;
    if (HWY_UNLIKELY(rays_.lanes.is_integer)) return integers(block, number, rest);
    if constexpr (Derived::wants_t) {
      for (unsigned faces = verdicts.face; faces != 0; faces &= faces - 1) {
        if (face(block, number, __builtin_ctz(faces))) return true;
      }
      rest = verdicts.uncertain;
    } else if (takes_all_ && verdicts.face != 0) {
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

  /// One of which the lanes are sure.
  HWY_NOINLINE HWY_FLATTEN bool face(const TriangleBlock<T>& block, std::uint32_t number, int i) {
    if (!query_.sees(block.index[i])) return false;
    query_.tally.template add<&Statistics::filter_hits>(1);
    const bool is_front = (terms_.front >> i & 1) != 0;
    if (!query_.takes(TriangleKind::face, is_front ? Facing::front : Facing::back)) return false;
    Candidate& found = candidate(block, number, i);
    const double whole = terms_.whole[i], distance = terms_.distance[i], error = terms_.error[i],
                 distance_error = terms_.distance_error[i];
    found.is_face = true;
    found.is_rough = sizeof(T) < sizeof(double);
    found.t = enclose(distance, whole, distance_error, error);
    // The same bounds for determinants in double: of its unit, and with room for the 16 roundings at most that a bound takes.
    constexpr double share = numeric::unit / numeric::unit_of<T> * (sizeof(T) < sizeof(double) ? 1 + 0x1p-18 : 1);
    found.bounds = {share * error, share * distance_error, is_front};
    if (HWY_UNLIKELY(is_loose(found)) && found.t.low <= end_) sharpen(found);
    return self().hit(found);
  }

  /// Whether floats leave so much of the ray behind the hit that more is visited there than a better bound costs. So it is with
  /// triangles that are small beside their distance.
  [[nodiscard]] static HWY_INLINE bool is_loose(const Candidate& found) {
    return sizeof(T) < sizeof(double) && found.t.high - found.t.low > loose * numeric::magnitude(found.t.high);
  }
  static constexpr double loose = 0x1p-8;
  HWY_NOINLINE HWY_FLATTEN void sharpen(Candidate& found) const { found = sharpened(query_, found); }

  /// One that the lanes have not settled, again in double, and then exactly. Not inlined: few come here.
  HWY_NOINLINE HWY_FLATTEN bool triangle(const TriangleBlock<T>& block, std::uint32_t number, int i) {
    using predicates::TriangleVerdict;
    if (!query_.sees(block.index[i])) return false;
    const Triangle<T> triangle = block.triangle(i);
    Candidate& found = candidate(block, number, i);
    const predicates::TriangleTerms<double> terms = predicates::triangle_terms<double>(query_.ray, triangle);
    const TriangleVerdict verdict = predicates::verdict(terms, query_.ray);
    if (verdict == TriangleVerdict::miss) {
      query_.tally.template add<&Statistics::filter_misses>(1);
      return false;
    }
    // Where ray and plane meet, which is the hit, if there is one.
    const bool is_bounded = terms.are_bounded && terms.whole > terms.error;
    if (Derived::wants_t && is_bounded) found.t = enclose(terms);
    found.bounds = rounding::bounds_of(terms);
    found.is_face = verdict == TriangleVerdict::face;
    if (found.is_face) {
      query_.tally.template add<&Statistics::filter_hits>(1);
      if (!query_.takes(TriangleKind::face, terms.is_front ? Facing::front : Facing::back)) return false;
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
      Candidate& found = candidate(block, number, i);
      if (bit(met)) {
        query_.tally.template add<&Statistics::filter_hits>(1);
        // Of a point in the plane options see only the side.
        if (!query_.takes(TriangleKind::face, bit(verdicts.front) ? Facing::front : Facing::back)) continue;
        found.is_face = bit(verdicts.inner);
        found.is_integer = true;
        found.whole = verdicts.whole[i];
        found.distance = verdicts.distance[i];
        found.bounds = {0, 0, bit(verdicts.front)};
        if (Derived::wants_t) found.t = enclose(found.distance, found.whole, 0, 0);
      } else {
        const Triangle<T> triangle = block.triangle(i);
        if (!decide(triangle)) continue;
        if (Derived::wants_t) found.t = exact::enclose_first(query_.ray, triangle);
      }
      if (self().hit(found)) return true;
    }
    return false;
  }

  /// A shape's, where the query wants it, so that it need not be copied: what is copied right after it was written by parts
  /// has to wait for them.
  template <class Block>
  [[nodiscard]] HWY_INLINE Candidate& candidate(const Block& block, std::uint32_t number, int i) {
    Candidate& found = self().space();
    found.shape = std::same_as<Block, SphereBlock<T>> ? Shape::sphere : Shape::triangle;
    found.is_face = found.is_integer = found.is_rough = false;
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
      Candidate& found = candidate(block, number, i);
      if (Derived::wants_t) {
        found.t = is_certain ? enclose(query_.ray, sphere, terms, verdict) : exact::enclose_first(query_.ray, sphere);
      }
      if (self().hit(found)) return true;
    }
    return false;
  }
};

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
