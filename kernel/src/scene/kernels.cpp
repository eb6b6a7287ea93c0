// The hot loops, compiled for each of Highway's targets: this file and the -inl files are included again for each.
#include "batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/kernels.cpp"
// The first must come before all, the last after all.
// clang-format off
#include "scene/kernels.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <limits>
#include <new>

#include "scene/batches-inl.hpp"
#include "scene/inside-inl.hpp"
#include "scene/visitors-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

template <Real T, class Tally>
HWY_FLATTEN void closest(const Query<T, Tally>& query, SceneHit<T>& answer) noexcept {
  const auto [is_plain, status] = admit(query.ray);
  answer.status = status;
  if (HWY_UNLIKELY(status != Status::ok)) return;
  ClosestVisitor<T, Tally> visitor(query, is_plain);
  visitor.run();
  if (visitor.best().shape != Shape::none) round_to(answer, query, visitor.best());
}
template <Real T, class Tally>
HWY_FLATTEN bool any(const Query<T, Tally>& query) noexcept {
  const auto [is_plain, status] = admit(query.ray);
  if (HWY_UNLIKELY(status != Status::ok)) return false;
  AnyVisitor<T, Tally> visitor(query, is_plain);
  visitor.run();
  return visitor.is_hit;
}
template <Real T, class Tally>
HWY_FLATTEN std::uint64_t count(const Query<T, Tally>& query) noexcept {
  const auto [is_plain, status] = admit(query.ray);
  if (HWY_UNLIKELY(status != Status::ok)) return 0;
  CountVisitor<T, Tally> visitor(query, is_plain);
  visitor.run();
  return visitor.sum;
}
template <Real T, class Tally>
HWY_FLATTEN void collect(const Query<T, Tally>& query, bool only_closest, std::vector<Candidate>& found) {
  const auto [is_plain, status] = admit(query.ray);
  if (status != Status::ok) return;
  CollectVisitor<T, Tally>(query, is_plain, only_closest, found).run();
}
template <Real T, class Tally>
SceneHit<T> rounded(const Query<T, Tally>& query, const Candidate& candidate) noexcept {
  SceneHit<T> hit;
  round_to(hit, query, candidate);
  return hit;
}
template <Real T, class Tally>
HWY_FLATTEN Place inside(const Query<T, Tally>& query) noexcept {
  return InsideVisitor<T, Tally>(query).place();
}

unsigned children_met(const BoxRay& ray, const Node& node, float* entry) noexcept {
  alignas(64) float at[width];
  const unsigned met = meet_boxes(RayAtBoxes<BoxLanes>(ray), ray.high, node, at);
  for (int i = 0; i < width; ++i) entry[i] = at[i];
  return met;
}

template <Real T>
BoxRay box_ray_of(const Space& space, const Box& root, const Ray<T>& ray) noexcept {
  BoxRay out;
  bring(space, root, ray, is_plain(ray), out);
  return out;
}

template <Real T, class Tally>
constexpr QueryKernels<T, Tally> query_kernels{closest<T, Tally>, any<T, Tally>,     count<T, Tally>,
                                               collect<T, Tally>, rounded<T, Tally>, inside<T, Tally>};

template <Real T>
constexpr BatchKernels<T> batch_kernels{closest_of_each<T>, any_of_each<T>, count_of_each<T>, box_ray_of<T>};

const Kernels& target_kernels() {
  static constexpr Kernels table{query_kernels<float, Silent>,
                                 query_kernels<float, Counting>,
                                 query_kernels<double, Silent>,
                                 query_kernels<double, Counting>,
                                 batch_kernels<float>,
                                 batch_kernels<double>,
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
