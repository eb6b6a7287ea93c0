// closest, any, count, all, ties.
#include <algorithm>
#include <new>

#include "exact/validate.hpp"
#include "graze/scene.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "scene/parallel.hpp"
#include "scene/walk.hpp"

namespace graze {
namespace scene {
namespace {

template <Real T>
[[nodiscard]] Status status_of(const Ray<T>& ray) noexcept {
  return exact::status_of(ray, true, false);
}

/// Calls hit(candidate, enclosure) for each primitive met, its enclosure not yet filled in, until one returns true.
template <Real T, class Tally, class Hit>
void each_hit(const Query<T, Tally>& query, BoxRay& box_ray, Hit hit) noexcept {
  walk(query, box_ray, [&](Child leaf) {
    if (!leaf.is_spheres()) {
      const TriangleBlock<T>& block = query.data.triangles[leaf.index()];
      return meet(query, block, [&](int i, auto enclosure) {
        return hit(
            [&] {
              return Candidate<T>{Shape::triangle, block.index[i], {}, block.triangle(i), {}};
            },
            enclosure, block.index[i]);
      });
    }
    const SphereBlock<T>& block = query.data.spheres[leaf.index()];
    return meet(query, block, [&](int i, auto enclosure) {
      return hit(
          [&] {
            return Candidate<T>{Shape::sphere, block.index[i], {}, {}, block.sphere(i)};
          },
          enclosure, block.index[i]);
    });
  });
}

template <Real T, class Tally>
[[nodiscard]] bool comes_before(const Query<T, Tally>& query, const Candidate<T>& one, const Candidate<T>& other) noexcept {
  if (one.t.high < other.t.low) return true;
  if (one.t.low > other.t.high) return false;
  query.tally.template add<&Statistics::exact_orders>(1);
  const int order = compare_exactly(query.ray, one, other);
  return order != 0 ? order < 0 : one.index < other.index;
}

template <Real T, class Tally>
[[nodiscard]] SceneHit<T> rounded(const Query<T, Tally>& query, const Candidate<T>& c) noexcept {
  query.tally.template add<&Statistics::roundings>(1);
  SceneHit<T> hit;
  hit.shape = c.shape;
  hit.index = c.index;
  if (c.shape == Shape::triangle) hit.triangle = intersect(query.ray, c.triangle);
  if (c.shape == Shape::sphere) hit.sphere = intersect(query.ray, c.sphere);
  return hit;
}

template <Real T>
[[nodiscard]] BoxRay box_ray(const Data<T>& data, const Ray<T>& ray) noexcept {
  return box_ray(data.space, data.root, ray);
}

template <Real T, class Tally>
[[nodiscard]] SceneHit<T> closest(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  SceneHit<T> answer;
  answer.status = status_of(ray);
  if (answer.status != Status::ok) return answer;
  const Query<T, Tally> query(data, ray, options, tally);
  BoxRay box = box_ray(data, ray);
  Candidate<T> best;
  each_hit(query, box, [&](auto candidate, auto enclosure, std::uint32_t) {
    const Enclosure t = enclosure();
    if (best.shape != Shape::none && t.low > best.t.high) return false;
    Candidate<T> found = candidate();
    found.t = t;
    if (best.shape == Shape::none || comes_before(query, found, best)) {
      // What comes first is not after the other's upper bound either.
      if (best.shape != Shape::none) found.t.high = std::min(found.t.high, best.t.high);
      best = found;
      box.end_at(best.t.high);
    }
    return false;
  });
  if (best.shape == Shape::none) return answer;
  return rounded(query, best);
}

template <Real T, class Tally>
[[nodiscard]] bool any(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  if (status_of(ray) != Status::ok) return false;
  const Query<T, Tally> query(data, ray, options, tally);
  BoxRay box = box_ray(data, ray);
  bool found = false;
  each_hit(query, box, [&](auto, auto, std::uint32_t) { return found = true; });
  return found;
}

template <Real T, class Tally>
[[nodiscard]] std::uint64_t count(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  if (status_of(ray) != Status::ok) return 0;
  const Query<T, Tally> query(data, ray, options, tally);
  BoxRay box = box_ray(data, ray);
  std::uint64_t n = 0;
  each_hit(query, box, [&](auto, auto, std::uint32_t) {
    ++n;
    return false;
  });
  return n;
}

/// Every hit, in no order; with `only_closest` those that may share the least t.
template <Real T, class Tally>
[[nodiscard]] std::vector<Candidate<T>> collect(const Query<T, Tally>& query, bool only_closest) {
  BoxRay box = box_ray(query.data, query.ray);
  std::vector<Candidate<T>> found;
  double least = std::numeric_limits<double>::infinity();
  bool is_out_of_memory = false;
  each_hit(query, box, [&](auto candidate, auto enclosure, std::uint32_t) {
    const Enclosure t = enclosure();
    if (only_closest && t.low > least) return false;
    try {
      found.push_back(candidate());
    } catch (const std::bad_alloc&) {
      return is_out_of_memory = true;
    }
    found.back().t = t;
    if (only_closest && t.high < least) {
      least = t.high;
      box.end_at(least);
    }
    return false;
  });
  if (is_out_of_memory) throw std::bad_alloc();
  return found;
}

template <Real T, class Tally>
[[nodiscard]] std::vector<SceneHit<T>> all(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) {
  if (status_of(ray) != Status::ok) return {};
  const Query<T, Tally> query(data, ray, options, tally);
  std::vector<Candidate<T>> found = collect(query, false);
  std::sort(found.begin(), found.end(), [&](const auto& one, const auto& other) { return comes_before(query, one, other); });
  std::vector<SceneHit<T>> hits;
  hits.reserve(found.size());
  for (const Candidate<T>& c : found) hits.push_back(rounded(query, c));
  return hits;
}

template <Real T>
[[nodiscard]] std::vector<SceneHit<T>> ties(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options) {
  if (status_of(ray) != Status::ok) return {};
  const Query<T, Silent> query(data, ray, options, {});
  std::vector<Candidate<T>> found = collect(query, true);
  std::vector<Candidate<T>> least;
  for (const Candidate<T>& c : found) {
    const int order = least.empty()               ? -1
                      : c.t.low > least[0].t.high ? 1
                      : c.t.high < least[0].t.low ? -1
                                                  : compare_exactly(ray, c, least[0]);
    if (order < 0) least.clear();
    if (order <= 0) least.push_back(c);
  }
  std::sort(least.begin(), least.end(), [](const auto& one, const auto& other) { return one.index < other.index; });
  std::vector<SceneHit<T>> hits;
  hits.reserve(least.size());
  for (const Candidate<T>& c : least) hits.push_back(rounded(query, c));
  return hits;
}

/// Rays a task: enough to pay for it.
constexpr std::size_t grain = 64;

template <class Question, class Answer, class Ask>
void each(std::span<const Question> questions, std::span<Answer> answers, Threads threads, Ask ask) {
  for_ranges(std::min(questions.size(), answers.size()), grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = ask(questions[i]);
  });
}

}  // namespace
}  // namespace scene

template <Real T>
SceneHit<T> Scene<T>::closest(const Ray<T>& ray, const QueryOptions& options) const noexcept {
  return scene::closest(*data_, ray, options, scene::Silent{});
}
template <Real T>
SceneHit<T> Scene<T>::closest(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept {
  return scene::closest(*data_, ray, options, scene::Counting{statistics});
}
template <Real T>
bool Scene<T>::any(const Ray<T>& ray, const QueryOptions& options) const noexcept {
  return scene::any(*data_, ray, options, scene::Silent{});
}
template <Real T>
bool Scene<T>::any(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept {
  return scene::any(*data_, ray, options, scene::Counting{statistics});
}
template <Real T>
std::uint64_t Scene<T>::count(const Ray<T>& ray, const QueryOptions& options) const noexcept {
  return scene::count(*data_, ray, options, scene::Silent{});
}
template <Real T>
std::uint64_t Scene<T>::count(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept {
  return scene::count(*data_, ray, options, scene::Counting{statistics});
}
template <Real T>
std::vector<SceneHit<T>> Scene<T>::all(const Ray<T>& ray, const QueryOptions& options) const {
  return scene::all(*data_, ray, options, scene::Silent{});
}
template <Real T>
std::vector<SceneHit<T>> Scene<T>::all(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const {
  return scene::all(*data_, ray, options, scene::Counting{statistics});
}
template <Real T>
std::vector<SceneHit<T>> Scene<T>::ties(const Ray<T>& ray, const QueryOptions& options) const {
  return scene::ties(*data_, ray, options);
}

template <Real T>
void Scene<T>::closest(std::span<const Ray<T>> rays, std::span<SceneHit<T>> answers, const QueryOptions& options,
                       Threads threads) const {
  scene::each(rays, answers, threads, [&](const Ray<T>& ray) { return closest(ray, options); });
}
template <Real T>
void Scene<T>::any(std::span<const Ray<T>> rays, std::span<bool> answers, const QueryOptions& options, Threads threads) const {
  scene::each(rays, answers, threads, [&](const Ray<T>& ray) { return any(ray, options); });
}
template <Real T>
void Scene<T>::count(std::span<const Ray<T>> rays, std::span<std::uint64_t> answers, const QueryOptions& options,
                     Threads threads) const {
  scene::each(rays, answers, threads, [&](const Ray<T>& ray) { return count(ray, options); });
}
template <Real T>
void Scene<T>::all(std::span<const Ray<T>> rays, std::span<std::vector<SceneHit<T>>> answers, const QueryOptions& options,
                   Threads threads) const {
  scene::each(rays, answers, threads, [&](const Ray<T>& ray) { return all(ray, options); });
}

#define GRAZE_QUERIES(T)                                                                                                \
  template SceneHit<T> Scene<T>::closest(const Ray<T>&, const QueryOptions&) const noexcept;                            \
  template SceneHit<T> Scene<T>::closest(const Ray<T>&, const QueryOptions&, Statistics&) const noexcept;               \
  template bool Scene<T>::any(const Ray<T>&, const QueryOptions&) const noexcept;                                       \
  template bool Scene<T>::any(const Ray<T>&, const QueryOptions&, Statistics&) const noexcept;                          \
  template std::uint64_t Scene<T>::count(const Ray<T>&, const QueryOptions&) const noexcept;                            \
  template std::uint64_t Scene<T>::count(const Ray<T>&, const QueryOptions&, Statistics&) const noexcept;               \
  template std::vector<SceneHit<T>> Scene<T>::all(const Ray<T>&, const QueryOptions&) const;                            \
  template std::vector<SceneHit<T>> Scene<T>::all(const Ray<T>&, const QueryOptions&, Statistics&) const;               \
  template std::vector<SceneHit<T>> Scene<T>::ties(const Ray<T>&, const QueryOptions&) const;                           \
  template void Scene<T>::closest(std::span<const Ray<T>>, std::span<SceneHit<T>>, const QueryOptions&, Threads) const; \
  template void Scene<T>::any(std::span<const Ray<T>>, std::span<bool>, const QueryOptions&, Threads) const;            \
  template void Scene<T>::count(std::span<const Ray<T>>, std::span<std::uint64_t>, const QueryOptions&, Threads) const; \
  template void Scene<T>::all(std::span<const Ray<T>>, std::span<std::vector<SceneHit<T>>>, const QueryOptions&, Threads) const;
GRAZE_QUERIES(float)
GRAZE_QUERIES(double)
#undef GRAZE_QUERIES

}  // namespace graze
