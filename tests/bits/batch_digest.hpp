// The digest of answers_digest, by batches: each form of batch is to give what the single query gives.
#pragma once

#include <memory>
#include <type_traits>
#include <vector>

#include "graze/batch.hpp"
#include "tests/bits/digest.hpp"

namespace graze::fuzz {

/// Two arrays; a ray and an array of one; an array of one ray and a shape.
enum class BatchCall { pairs, one_ray, one_shape };

/// Queries of one kind as arrays, and the batches' answers.
template <class Query>
class QueryArrays;

template <Real T>
class QueryArrays<RaySphere<T>> {
 public:
  using Hit = SphereHit<T>;
  static const Sphere<T>& shape_of(const RaySphere<T>& query) { return query.sphere; }
  static batch::SphereArrays<T> shapes(const std::vector<T>* columns, std::size_t n) {
    return {{columns[6].data(), columns[7].data(), columns[8].data()}, columns[9].data(), n};
  }

  explicit QueryArrays(std::size_t n) : status_(n), kind_(n), root_(n), origin_(n), first_(n), second_(n) {}
  batch::SphereHitArrays<T> from(std::size_t i) {
    return {&status_[i], &kind_[i], &root_[i], &origin_[i], &first_[i], &second_[i]};
  }
  [[nodiscard]] Hit at(std::size_t i) const {
    Hit hit;
    hit.status = status_[i], hit.kind = kind_[i], hit.root = root_[i], hit.origin = origin_[i];
    hit.t[0] = first_[i], hit.t[1] = second_[i];
    return hit;
  }

 private:
  std::vector<Status> status_;
  std::vector<SphereKind> kind_;
  std::vector<Root> root_;
  std::vector<OriginSide> origin_;
  std::vector<T> first_, second_;
};

template <Real T>
class QueryArrays<RayTriangle<T>> {
 public:
  using Hit = TriangleHit<T>;
  static const Triangle<T>& shape_of(const RayTriangle<T>& query) { return query.triangle; }
  static batch::TriangleArrays<T> shapes(const std::vector<T>* columns, std::size_t n) {
    const auto vec3 = [&](std::size_t k) {
      return batch::Vec3Arrays<T>{columns[k].data(), columns[k + 1].data(), columns[k + 2].data()};
    };
    return {vec3(6), vec3(9), vec3(12), n};
  }

  explicit QueryArrays(std::size_t n) : status_(n), kind_(n), facing_(n), t_(n), t_end_(n), u_(n), v_(n) {}
  batch::TriangleHitArrays<T> from(std::size_t i) {
    return {&status_[i], &kind_[i], &facing_[i], &t_[i], &t_end_[i], &u_[i], &v_[i]};
  }
  [[nodiscard]] Hit at(std::size_t i) const {
    Hit hit;
    hit.status = status_[i], hit.kind = kind_[i], hit.facing = facing_[i];
    hit.t = t_[i], hit.t_end = t_end_[i], hit.u = u_[i], hit.v = v_[i];
    return hit;
  }

 private:
  std::vector<Status> status_;
  std::vector<TriangleKind> kind_;
  std::vector<Facing> facing_;
  std::vector<T> t_, t_end_, u_, v_;
};

/// Whole answers and decisions of all queries in that mode.
template <class Query>
struct BatchAnswers {
  QueryArrays<Query> hits;
  std::vector<std::uint64_t> mask;
};

template <Real T, class Query>
[[nodiscard]] BatchAnswers<Query> batch_answers(const std::vector<Query>& queries, BatchCall call, FloatMode mode) {
  const std::size_t n = queries.size();
  BatchAnswers<Query> out{QueryArrays<Query>(n), std::vector<std::uint64_t>(batch::mask_words(n))};
  std::vector<T> columns[17];
  for (const Query& query : queries) {
    std::size_t k = 0;
    for_each_number(query, [&](const T& x) { columns[k++].push_back(x); });
  }
  const std::size_t last = columns[15].empty() ? 10 : 15;
  const batch::RayArrays<T> rays{{columns[0].data(), columns[1].data(), columns[2].data()},
                                 {columns[3].data(), columns[4].data(), columns[5].data()},
                                 n,
                                 columns[last].data(),
                                 columns[last + 1].data()};
  const FloatModeScope scope(mode);
  if (call == BatchCall::pairs) {
    batch::intersect(rays, QueryArrays<Query>::shapes(columns, n), out.hits.from(0));
    batch::hits(rays, QueryArrays<Query>::shapes(columns, n), out.mask.data());
    return out;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Ray<T>& ray = queries[i].ray;
    const auto& shape = QueryArrays<Query>::shape_of(queries[i]);
    std::uint64_t bit = 0;
    std::vector<T> one[17];
    if (call == BatchCall::one_ray) {
      for (std::size_t k = 0; k < last; ++k) one[k].assign(1, columns[k][i]);
      batch::intersect(ray, QueryArrays<Query>::shapes(one, 1), out.hits.from(i));
      batch::hits(ray, QueryArrays<Query>::shapes(one, 1), &bit);
    } else {
      const auto& [e, d, t_min, t_max] = ray;
      const batch::RayArrays<T> single{{&e.x, &e.y, &e.z}, {&d.x, &d.y, &d.z}, 1, &t_min, &t_max};
      batch::intersect(single, shape, out.hits.from(i));
      batch::hits(single, shape, &bit);
    }
    out.mask[i / 64] |= bit << i % 64;
  }
  return out;
}

/// Takes one stream's cases; what is no query of batches is asked one by one.
template <Real T>
class BatchStreamDigest {
 public:
  explicit BatchStreamDigest(BatchCall call) : call_(call) {}

  void add(const Case<T>& input) {
    add_input(input, inputs_);
    cases_.push_back(input);
    if (const auto* sphere = std::get_if<RaySphere<T>>(&input)) spheres_.push_back(*sphere);
    if (const auto* triangle = std::get_if<RayTriangle<T>>(&input)) triangles_.push_back(*triangle);
  }

  [[nodiscard]] Digest digest() const {
    Digest digest{inputs_.text(), answers(float_modes[0])};
    for (std::size_t i = 1; i < float_modes.size(); ++i) {
      if (answers(float_modes[i]) != digest.answers) digest.unlike_modes.append("; ").append(name_of(float_modes[i]));
    }
    return digest;
  }

 private:
  [[nodiscard]] std::string answers(FloatMode mode) const {
    const auto spheres = batch_answers<T>(spheres_, call_, mode);
    const auto triangles = batch_answers<T>(triangles_, call_, mode);
    std::size_t sphere = 0, triangle = 0;
    Hash hash;
    const auto add_of = [&](const auto& all, std::size_t i) {
      hash.add(all.hits.at(i));
      hash.add(all.mask[i / 64] >> i % 64 & 1);
    };
    for (const Case<T>& input : cases_) {
      if (std::holds_alternative<RaySphere<T>>(input)) {
        add_of(spheres, sphere++);
      } else if (std::holds_alternative<RayTriangle<T>>(input)) {
        add_of(triangles, triangle++);
      } else {
        add_answer(input, mode, hash);
      }
    }
    return hash.text();
  }

  BatchCall call_;
  Hash inputs_;
  std::vector<Case<T>> cases_;
  std::vector<RaySphere<T>> spheres_;
  std::vector<RayTriangle<T>> triangles_;
};

}  // namespace graze::fuzz
