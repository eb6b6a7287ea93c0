// How wrong answers are, by the exact oracle: decisions by the certifier's comparison, numbers in units of the last place.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/entry.hpp"
#include "oracle/oracle.hpp"

namespace graze::bench {

template <class Query>
struct TruthOfQuery;
template <Real T>
struct TruthOfQuery<fuzz::RaySphere<T>> {
  using Type = oracle::SphereTruth<T>;
};
template <Real T>
struct TruthOfQuery<fuzz::RayTriangle<T>> {
  using Type = oracle::TriangleTruth<T>;
};
template <class Query>
using TruthOf = typename TruthOfQuery<Query>::Type;

/// The exact answers.
template <class Query>
[[nodiscard]] std::vector<TruthOf<Query>> truths_of(std::span<const Query> queries);

/// What one answer is: whether its decisions are right, and the errors of its numbers, in ulps of their format. A correctly
/// rounded number errs by at most 1/2. Only numbers of a right kind are held against anything.
struct Judgment {
  bool is_wrong = false;
  std::vector<double> t_errors;   ///< of t, both roots or the interval's ends
  std::vector<double> uv_errors;  ///< of u and v
  std::vector<bool> t_is_correct;
  /// The greatest of all; -1 where there is no number.
  [[nodiscard]] double worst() const;
};

/// `allowed` is what the kernel declares to do otherwise.
template <class Query>
[[nodiscard]] Judgment judge(const Query& query, const HitOf<Query>& answer, const TruthOf<Query>& truth,
                             const fuzz::Deviations& allowed);

/// Over many queries. The quantiles are of t's errors, of right kinds; infinity where such a t is a NaN or an infinity.
struct Errors {
  std::uint64_t queries = 0, hits = 0;  ///< hits: by the truth
  std::uint64_t wrong = 0;              ///< wrong kinds, sides, roots, features
  std::uint64_t values = 0, correct = 0;
  double median = 0, p999 = 0, max = 0;
  std::string worst_case;  ///< the case line of max, in hexadecimal; empty without values
};

template <class Query>
[[nodiscard]] Errors errors_of(std::span<const Query> queries, std::span<const TruthOf<Query>> truths,
                               std::span<const HitOf<Query>> answers, const fuzz::Deviations& allowed);
/// Of decisions alone.
template <class Query>
[[nodiscard]] Errors errors_of(std::span<const Query> queries, std::span<const TruthOf<Query>> truths,
                               const std::vector<bool>& decisions, const fuzz::Deviations& allowed);

/// The least element that no more than a share 1 - q of all exceeds (nearest rank); reorders its argument, which is not empty.
[[nodiscard]] double quantile(std::vector<double>& values, double q);

}  // namespace graze::bench
