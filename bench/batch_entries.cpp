#include "bench/batch_entries.hpp"

#include <memory>

#include "bench/columns.hpp"

namespace graze::bench {
namespace {

template <Real T>
struct SphereAnswers {
  std::vector<SphereKind> kind;
  std::vector<Root> root;
  std::vector<OriginSide> origin;
  std::vector<T> first, second;

  explicit SphereAnswers(std::size_t n) : kind(n), root(n), origin(n), first(n), second(n) {}
  [[nodiscard]] batch::SphereHitArrays<T> arrays() {
    return {nullptr, kind.data(), root.data(), origin.data(), first.data(), second.data()};
  }
  [[nodiscard]] SphereHit<T> at(std::size_t i) const {
    return {Status::ok, kind[i], root[i], origin[i], {first[i], second[i]}};
  }
};

template <Real T>
struct TriangleAnswers {
  std::vector<TriangleKind> kind;
  std::vector<Facing> facing;
  std::vector<T> t, t_end, u, v;

  explicit TriangleAnswers(std::size_t n) : kind(n), facing(n), t(n), t_end(n), u(n), v(n) {}
  [[nodiscard]] batch::TriangleHitArrays<T> arrays() {
    return {nullptr, kind.data(), facing.data(), t.data(), t_end.data(), u.data(), v.data()};
  }
  [[nodiscard]] TriangleHit<T> at(std::size_t i) const { return {Status::ok, kind[i], facing[i], t[i], t_end[i], u[i], v[i]}; }
};

template <class Query>
struct Parts;
template <Real T>
struct Parts<fuzz::RaySphere<T>> {
  using Shapes = SphereColumns<T>;
  using Answers = SphereAnswers<T>;
  static const Sphere<T>& shape(const fuzz::RaySphere<T>& q) { return q.sphere; }
};
template <Real T>
struct Parts<fuzz::RayTriangle<T>> {
  using Shapes = TriangleColumns<T>;
  using Answers = TriangleAnswers<T>;
  static const Triangle<T>& shape(const fuzz::RayTriangle<T>& q) { return q.triangle; }
};

/// Queries as arrays, and room for the answers.
template <class Query>
struct Arrays {
  RayColumns<std::remove_cvref_t<decltype(Query{}.ray.t_min)>> rays;
  typename Parts<Query>::Shapes shapes;
  typename Parts<Query>::Answers answers;
  std::vector<std::uint64_t> mask;

  explicit Arrays(std::span<const Query> queries) : answers(queries.size()), mask(batch::mask_words(queries.size())) {
    for (const Query& q : queries) {
      rays.add(q.ray);
      shapes.add(Parts<Query>::shape(q));
    }
  }
  void intersect() { batch::intersect(rays.arrays(), shapes.arrays(), answers.arrays()); }
  void decide() { batch::hits(rays.arrays(), shapes.arrays(), mask.data()); }
};

}  // namespace

template <class Query>
void add_batch_entries(std::vector<Entry<Query>>& entries) {
  Entry<Query> numbers{
      "graze-batch-intersect", "graze batch", "this library's batch intersect, pairs", true, {}, 1, {}, {}, {}};
  numbers.prepare = [](std::span<const Query> queries) -> Pass {
    const auto arrays = std::make_shared<Arrays<Query>>(queries);
    return [arrays] {
      arrays->intersect();
      return static_cast<std::size_t>(arrays->answers.kind.back());
    };
  };
  numbers.answers = [](std::span<const Query> queries) {
    Arrays<Query> arrays(queries);
    arrays.intersect();
    std::vector<HitOf<Query>> out;
    for (std::size_t i = 0; i < queries.size(); ++i) out.push_back(arrays.answers.at(i));
    return out;
  };
  entries.push_back(std::move(numbers));

  Entry<Query> decisions{"graze-batch-hits", "graze batch", "this library's batch hits, pairs", true, {}, 1, {}, {}, {}};
  decisions.prepare = [](std::span<const Query> queries) -> Pass {
    const auto arrays = std::make_shared<Arrays<Query>>(queries);
    return [arrays] {
      arrays->decide();
      return static_cast<std::size_t>(arrays->mask[0]);
    };
  };
  decisions.decisions = [](std::span<const Query> queries) {
    Arrays<Query> arrays(queries);
    arrays.decide();
    std::vector<bool> out;
    for (std::size_t i = 0; i < queries.size(); ++i) out.push_back((arrays.mask[i / 64] >> (i % 64) & 1) != 0);
    return out;
  };
  entries.push_back(std::move(decisions));
}

template void add_batch_entries(std::vector<Entry<fuzz::RaySphere<float>>>&);
template void add_batch_entries(std::vector<Entry<fuzz::RaySphere<double>>>&);
template void add_batch_entries(std::vector<Entry<fuzz::RayTriangle<float>>>&);
template void add_batch_entries(std::vector<Entry<fuzz::RayTriangle<double>>>&);

}  // namespace graze::bench
