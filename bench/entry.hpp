// One way to answer a query, of ours or another's: what is timed and judged.
#pragma once

#include <bit>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"

namespace graze::bench {

template <class Query>
struct HitOfQuery;
template <Real T>
struct HitOfQuery<fuzz::RaySphere<T>> {
  using Type = SphereHit<T>;
};
template <Real T>
struct HitOfQuery<fuzz::RayTriangle<T>> {
  using Type = TriangleHit<T>;
};
template <class Query>
using HitOf = typename HitOfQuery<Query>::Type;

/// One pass over the queries it was made for; returns a checksum, so that no work is dropped.
using Pass = std::function<std::size_t()>;

template <class Query>
struct Entry {
  std::string name;   ///< in results; unlike names for unlike work
  std::string label;  ///< in pictures
  std::string about;  ///< one line: the formula
  bool is_ours = false;
  fuzz::Deviations deviations;
  std::size_t stride = 1;  ///< slow ones are timed on every stride-th query
  /// Makes a pass; what it may convert beforehand is no part of the time. The queries outlive it.
  std::function<Pass(std::span<const Query>)> prepare;
  /// The answers to be judged: one of the two, whole answers or decisions alone.
  std::function<std::vector<HitOf<Query>>(std::span<const Query>)> answers;
  std::function<std::vector<bool>(std::span<const Query>)> decisions;
};

template <Real T>
std::size_t checksum(T x) {
  if constexpr (sizeof(T) == sizeof(float)) {
    return std::bit_cast<std::uint32_t>(x) & 1;
  } else {
    return std::bit_cast<std::uint64_t>(x) & 1;
  }
}
/// Of all numbers, so that all are computed.
template <Real T>
std::size_t checksum(const SphereHit<T>& h) {
  return static_cast<std::size_t>(h.kind) + checksum(h.t[0]) + checksum(h.t[1]);
}
template <Real T>
std::size_t checksum(const TriangleHit<T>& h) {
  return static_cast<std::size_t>(h.kind) + checksum(h.t) + checksum(h.u) + checksum(h.v);
}

/// Whole answers by `answer(query)`, which is inlined into the timed loop.
template <class Query, class Answer>
Entry<Query> numbers_entry(std::string name, std::string label, std::string about, fuzz::Deviations deviations, Answer answer) {
  Entry<Query> entry{std::move(name), std::move(label), std::move(about), false, deviations, 1, {}, {}, {}};
  entry.prepare = [answer](std::span<const Query> queries) -> Pass {
    return [queries, answer] {
      std::size_t sum = 0;
      for (const Query& query : queries) sum += checksum(answer(query));
      return sum;
    };
  };
  entry.answers = [answer](std::span<const Query> queries) {
    std::vector<HitOf<Query>> out;
    for (const Query& query : queries) out.push_back(answer(query));
    return out;
  };
  return entry;
}

/// Decisions by `hits(query)`, likewise.
template <class Query, class Hits>
Entry<Query> decision_entry(std::string name, std::string label, std::string about, fuzz::Deviations deviations, Hits hits) {
  Entry<Query> entry{std::move(name), std::move(label), std::move(about), false, deviations, 1, {}, {}, {}};
  entry.prepare = [hits](std::span<const Query> queries) -> Pass {
    return [queries, hits] {
      std::size_t sum = 0;
      for (const Query& query : queries) sum += hits(query) ? 1 : 0;
      return sum;
    };
  };
  entry.decisions = [hits](std::span<const Query> queries) {
    std::vector<bool> out;
    for (const Query& query : queries) out.push_back(hits(query));
    return out;
  };
  return entry;
}

}  // namespace graze::bench
