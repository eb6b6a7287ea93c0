// Many shapes, many rays: the closest hit, any hit, all hits, their number; inside or outside.
//
// Every answer is what testing every primitive with `intersect` would say, with ties of exact t settled by the lowest index. A
// scene is immutable but for `refit`: any number of threads may ask it at once. Queries neither throw nor allocate, but for
// `all` and `ties`, whose answers are lists. Floating-point modes are as in triangle.hpp: none matters, none is changed.
// Linked as graze::scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "graze/numeric/platform.hpp"
#include "graze/scene/parts.hpp"
#include "graze/scene/query.hpp"

namespace graze {

namespace scene {
template <Real T>
struct Data;
}

struct BuildOptions {
  /// Also make the scene answer `inside`: refused unless each directed edge of its meshes occurs as often as its reverse, where
  /// points are the same whose coordinates are. Spheres are closed by themselves.
  bool is_closed = false;
  Threads threads = Threads::all;
  /// Lists triangles whose boxes are mostly empty in several leaves, under smaller boxes: fewer triangles tested a ray where
  /// they are long and thin, for up to twice the memory and a longer build. Answers are the same. `refit` gives each of these
  /// leaves the box of the whole triangle.
  bool spatial_splits = false;
};

template <Real T>
struct Bounds {
  Vec3<T> low, high;
  bool operator==(const Bounds&) const = default;
};

/// Primitives are numbered from 0 in the order of the parts and of each part's triangles or spheres.
template <Real T>
class Scene {
 public:
  /// A scene of nothing.
  Scene();
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Makes this the scene of the parts. Where that fails the scene is left as it was.
  [[nodiscard]] BuildStatus build(std::vector<Part<T>> parts, const BuildOptions& options = {});

  /// Takes other points for a mesh, or other spheres, as many as there were. Cheaper than building, but the more the shapes
  /// move the slower the queries become; a scene of doubles is built anew, beside the hierarchy that it has, where more points
  /// come apart that were one than a leaf can hold. Where that fails the scene is left as it was. Not to be called beside
  /// queries.
  [[nodiscard]] BuildStatus refit(std::size_t part, Array<Vec3<T>> points);
  [[nodiscard]] BuildStatus refit(std::size_t part, Array<Sphere<T>> spheres);
  /// The same where viewed points or spheres have been moved in place.
  [[nodiscard]] BuildStatus refit();

  /// Whether the ray is valid, and if not, why it has no answer.
  [[nodiscard]] static Status status_of(const Ray<T>& ray) noexcept;

  /// The hit of least exact t; of equal t, the one of the lowest index.
  [[nodiscard]] SceneHit<T> closest(const Ray<T>& ray, const QueryOptions& options = {}) const noexcept;
  /// Whether there is a hit. False for an invalid ray.
  [[nodiscard]] bool any(const Ray<T>& ray, const QueryOptions& options = {}) const noexcept;
  /// How many primitives are hit. 0 for an invalid ray.
  [[nodiscard]] std::uint64_t count(const Ray<T>& ray, const QueryOptions& options = {}) const noexcept;
  /// Every hit, by exact t, then index. Empty for an invalid ray. Throws std::bad_alloc.
  [[nodiscard]] std::vector<SceneHit<T>> all(const Ray<T>& ray, const QueryOptions& options = {}) const;
  /// The hits whose exact t is that of the closest, by index. Empty for an invalid ray. Throws std::bad_alloc.
  [[nodiscard]] std::vector<SceneHit<T>> ties(const Ray<T>& ray, const QueryOptions& options = {}) const;
  /// By the even-odd rule; exact.
  [[nodiscard]] Place inside(const Vec3<T>& point) const noexcept;

  /// The same for each ray or point, answers in order; the spans are of one length.
  void closest(std::span<const Ray<T>> rays, std::span<SceneHit<T>> answers, const QueryOptions& options = {},
               Threads threads = Threads::all) const;
  void any(std::span<const Ray<T>> rays, std::span<bool> answers, const QueryOptions& options = {},
           Threads threads = Threads::all) const;
  void count(std::span<const Ray<T>> rays, std::span<std::uint64_t> answers, const QueryOptions& options = {},
             Threads threads = Threads::all) const;
  void all(std::span<const Ray<T>> rays, std::span<std::vector<SceneHit<T>>> answers, const QueryOptions& options = {},
           Threads threads = Threads::all) const;
  void inside(std::span<const Vec3<T>> points, std::span<Place> answers, Threads threads = Threads::all) const;

  /// The same, counting what was done.
  [[nodiscard]] SceneHit<T> closest(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept;
  [[nodiscard]] bool any(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept;
  [[nodiscard]] std::uint64_t count(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const noexcept;
  [[nodiscard]] std::vector<SceneHit<T>> all(const Ray<T>& ray, const QueryOptions& options, Statistics& statistics) const;
  [[nodiscard]] Place inside(const Vec3<T>& point, Statistics& statistics) const noexcept;

  /// How many primitives there are.
  [[nodiscard]] std::size_t size() const noexcept;
  /// A box that holds every primitive: exact for triangles, for spheres rounded outward. All zero for a scene of nothing.
  [[nodiscard]] Bounds<T> bounds() const noexcept;
  /// Bytes held, moved-in arrays included.
  [[nodiscard]] std::size_t memory() const noexcept;
  [[nodiscard]] bool is_closed() const noexcept;

 private:
  std::unique_ptr<scene::Data<T>> data_;
};

extern template class Scene<float>;
extern template class Scene<double>;

}  // namespace graze
