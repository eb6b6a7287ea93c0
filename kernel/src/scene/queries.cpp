// closest, any, count, all, ties, inside.
#include <algorithm>

#include "exact/validate.hpp"
#include "graze/scene.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "scene/kernels.hpp"
#include "scene/parallel.hpp"

namespace graze {
namespace scene {
namespace {

template <Real T, class Tally>
[[nodiscard]] SceneHit<T> closest(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  SceneHit<T> answer;
  const Query<T, Tally> query{data, ray, options, tally};
  kernels(query).closest(query, answer);
  return answer;
}

template <Real T, class Tally>
[[nodiscard]] bool any(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  const Query<T, Tally> query{data, ray, options, tally};
  return kernels(query).any(query);
}

template <Real T, class Tally>
[[nodiscard]] std::uint64_t count(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) noexcept {
  const Query<T, Tally> query{data, ray, options, tally};
  return kernels(query).count(query);
}

template <Real T, class Tally>
[[nodiscard]] std::vector<SceneHit<T>> all(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, Tally tally) {
  const Query<T, Tally> query{data, ray, options, tally};
  std::vector<Candidate> found;
  kernels(query).collect(query, false, found);
  std::sort(found.begin(), found.end(), [&](const auto& one, const auto& other) { return comes_before(query, one, other); });
  std::vector<SceneHit<T>> hits;
  hits.reserve(found.size());
  for (const Candidate& c : found) hits.push_back(kernels(query).rounded(query, c));
  return hits;
}

template <Real T>
[[nodiscard]] std::vector<SceneHit<T>> ties(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options) {
  const Query<T, Silent> query{data, ray, options, {}};
  std::vector<Candidate> found, least;
  kernels(query).collect(query, true, found);
  for (const Candidate& c : found) {
    const int order = least.empty() ? -1 : compare(query, c, least[0]);
    if (order < 0) least.clear();
    if (order <= 0) least.push_back(c);
  }
  std::sort(least.begin(), least.end(), [](const auto& one, const auto& other) { return one.index < other.index; });
  // Spatial splits list a triangle in several leaves.
  const auto last =
      std::unique(least.begin(), least.end(), [](const auto& one, const auto& other) { return one.index == other.index; });
  least.erase(last, least.end());
  std::vector<SceneHit<T>> hits;
  hits.reserve(least.size());
  for (const Candidate& c : least) hits.push_back(kernels(query).rounded(query, c));
  return hits;
}

template <Real T, class Tally>
[[nodiscard]] Place inside(const Data<T>& data, const Vec3<T>& point, Tally tally) noexcept {
  if (!data.options.is_closed || !numeric::is_finite(point)) return Place::unknown;
  const Ray<T> ray{point, {T(1), T(0), T(0)}};
  const QueryOptions options;
  const Query<T, Tally> query{data, ray, options, tally};
  return kernels(query).inside(query);
}

/// Rays a task: enough to pay for it.
constexpr std::size_t grain = 64;

template <class Question, class Answer, class Ask>
void each(std::span<const Question> questions, std::span<Answer> answers, Threads threads, Ask ask) {
  for_ranges(std::min(questions.size(), answers.size()), grain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) answers[i] = ask(questions[i]);
  });
}

/// Rays a task of those that keep many on their way at once, beside which the few of its beginning and end count little.
constexpr std::size_t batch_grain = 1024;

template <Real T, class Answer, class Ask>
void batch(const Data<T>& data, std::span<const Ray<T>> rays, std::span<Answer> answers, const QueryOptions& options,
           Threads threads, Ask ask) {
  for_ranges(std::min(rays.size(), answers.size()), batch_grain, threads, [&](std::size_t begin, std::size_t end) {
    ask(data, rays.subspan(begin, end - begin), options, answers.data() + begin);
  });
}

}  // namespace
}  // namespace scene

template <Real T>
Status Scene<T>::status_of(const Ray<T>& ray) noexcept {
  return exact::status_of(ray, true, false);
}

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
Place Scene<T>::inside(const Vec3<T>& point) const noexcept {
  return scene::inside(*data_, point, scene::Silent{});
}
template <Real T>
Place Scene<T>::inside(const Vec3<T>& point, Statistics& statistics) const noexcept {
  return scene::inside(*data_, point, scene::Counting{statistics});
}

template <Real T>
void Scene<T>::closest(std::span<const Ray<T>> rays, std::span<SceneHit<T>> answers, const QueryOptions& options,
                       Threads threads) const {
  scene::batch(*data_, rays, answers, options, threads, data_->kernels->template batches<T>().closest);
}
template <Real T>
void Scene<T>::any(std::span<const Ray<T>> rays, std::span<bool> answers, const QueryOptions& options, Threads threads) const {
  scene::batch(*data_, rays, answers, options, threads, data_->kernels->template batches<T>().any);
}
template <Real T>
void Scene<T>::count(std::span<const Ray<T>> rays, std::span<std::uint64_t> answers, const QueryOptions& options,
                     Threads threads) const {
  scene::batch(*data_, rays, answers, options, threads, data_->kernels->template batches<T>().count);
}
template <Real T>
void Scene<T>::all(std::span<const Ray<T>> rays, std::span<std::vector<SceneHit<T>>> answers, const QueryOptions& options,
                   Threads threads) const {
  scene::each(rays, answers, threads, [&](const Ray<T>& ray) { return all(ray, options); });
}
template <Real T>
void Scene<T>::inside(std::span<const Vec3<T>> points, std::span<Place> answers, Threads threads) const {
  scene::each(points, answers, threads, [&](const Vec3<T>& point) { return inside(point); });
}

#define GRAZE_QUERIES(T)                                                                                                \
  template Status Scene<T>::status_of(const Ray<T>&) noexcept;                                                          \
  template Place Scene<T>::inside(const Vec3<T>&) const noexcept;                                                       \
  template Place Scene<T>::inside(const Vec3<T>&, Statistics&) const noexcept;                                          \
  template void Scene<T>::inside(std::span<const Vec3<T>>, std::span<Place>, Threads) const;                            \
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
