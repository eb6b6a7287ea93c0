// Per target: what `inside` does with a leaf. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_INSIDE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_INSIDE_INL
#undef GRAZE_SCENE_INSIDE_INL
#else
#define GRAZE_SCENE_INSIDE_INL
#endif

#include "exact/parity.hpp"
#include "graze/implicit.hpp"
#include "scene/home-inl.hpp"
#include "scene/rays-inl.hpp"
#include "scene/triangles-inl.hpp"
#include "scene/walk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Counts the crossings of the way out from the ray's origin along +x. A primitive that the point is on, or a sphere that holds
/// it, is met by that ray too, so its leaf is visited.
template <Real T, class Tally>
class InsideVisitor {
 public:
  explicit InsideVisitor(const Query<T, Tally>& query) : query_(query), rays_(query.data, query.ray, is_plain(query.ray)) {}

  [[nodiscard]] HWY_INLINE Place place() {
    walk<false>(query_, box_, *this, Child::node(0));
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

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
