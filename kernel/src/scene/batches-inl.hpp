// Per target: the queries of a span of rays. Included anew for each target by kernels.cpp.
#if defined(GRAZE_SCENE_BATCHES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_SCENE_BATCHES_INL
#undef GRAZE_SCENE_BATCHES_INL
#else
#define GRAZE_SCENE_BATCHES_INL
#endif

#include "scene/rounded-inl.hpp"
#include "scene/streams-inl.hpp"
#include "scene/visitors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace graze::scene::HWY_NAMESPACE {

/// Asks each ray of a span by a Visitor of its own; tell(i, visitor) has the answers, reject(i, status) the rays that are
/// invalid.
template <class Visitor, Real T, class Tell, class Reject>
class Batch {
 public:
  Batch(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options, const Tell& tell, const Reject& reject)
      : data_(data), rays_(rays), options_(options), tell_(tell), reject_(reject) {}

  struct Asked {
    Asked(const Data<T>& data, const Ray<T>& ray, const QueryOptions& options, bool is_plain)
        : query{data, ray, options, {}}, visitor(query, is_plain) {}
    Query<T, Silent> query;
    Visitor visitor;
  };

  /// Makes the visitor of ray i; false where it needs none.
  HWY_NOINLINE HWY_FLATTEN bool start(void* at, std::size_t i) {
    const Ray<T>& ray = rays_[i];
    const auto [is_plain, status] = admit(ray);
    if (HWY_UNLIKELY(status != Status::ok)) {
      reject_(i, status);
      return false;
    }
    new (at) Asked(data_, ray, options_, is_plain);
    return true;
  }
  HWY_INLINE void finish(Asked& asked, std::size_t i) { tell_(i, asked.query, asked.visitor); }

  void run() { Streams<Asked, T, Batch>(data_, rays_.size(), *this).run(); }

 private:
  const Data<T>& data_;
  std::span<const Ray<T>> rays_;
  const QueryOptions& options_;
  const Tell& tell_;
  const Reject& reject_;
};

template <class Visitor, Real T, class Tell, class Reject>
HWY_INLINE void ask(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options, const Tell& tell,
                    const Reject& reject) {
  Batch<Visitor, T, Tell, Reject>(data, rays, options, tell, reject).run();
}

template <Real T>
void closest_of_each(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options,
                     SceneHit<T>* answers) noexcept {
  ask<ClosestVisitor<T, Silent>>(
      data, rays, options,
      [&](std::size_t i, const auto& query, const auto& visitor) HWY_ATTR {
        answers[i] = {};
        if (visitor.best().shape != Shape::none) round_to(answers[i], query, visitor.best());
      },
      [&](std::size_t i, Status status) { answers[i] = {.status = status}; });
}
template <Real T>
void any_of_each(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options, bool* answers) noexcept {
  ask<AnyVisitor<T, Silent>>(
      data, rays, options, [&](std::size_t i, const auto&, const auto& visitor) HWY_ATTR { answers[i] = visitor.is_hit; },
      [&](std::size_t i, Status) { answers[i] = false; });
}
template <Real T>
void count_of_each(const Data<T>& data, std::span<const Ray<T>> rays, const QueryOptions& options,
                   std::uint64_t* answers) noexcept {
  ask<CountVisitor<T, Silent>>(
      data, rays, options, [&](std::size_t i, const auto&, const auto& visitor) HWY_ATTR { answers[i] = visitor.sum; },
      [&](std::size_t i, Status) { answers[i] = 0; });
}

}  // namespace graze::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
