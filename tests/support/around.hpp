// Ranges whose ends are the numbers of the answer, and their neighbours: an end is compared with the exact t, before rounding.
#pragma once

#include <cmath>
#include <vector>

#include "tests/support/agreement.hpp"

namespace graze::test {

template <Real T>
[[nodiscard]] std::vector<T> parameters_of(const fuzz::Answer<T>& answer) {
  if (const auto* hit = std::get_if<SphereHit<T>>(&answer)) return {hit->t, hit->t + hit->count()};
  const auto& hit = std::get<TriangleHit<T>>(answer);
  if (!fuzz::is_hit(answer)) return {};
  if (hit.is_interval()) return {hit.t, hit.t_end};
  return {hit.t};
}

/// Requires agreement for ranges from, to, and at each number of the answer over the whole line, and the next numbers to either
/// side. Returns how many ranges that were.
template <Real T, class Query>
int require_agreement_around_answers(Query query) {
  constexpr T greatest = std::numeric_limits<T>::max(), infinity = std::numeric_limits<T>::infinity();
  query.ray.t_min = -greatest;
  query.ray.t_max = infinity;
  int ranges = 0;
  for (const T t : parameters_of<T>(require_agreement(fuzz::Case<T>(query)))) {
    for (const T end : {std::nextafter(t, -infinity), t, std::nextafter(t, infinity)}) {
      const auto ask = [&](T t_min, T t_max) {
        if (!std::isfinite(t_min)) return;
        query.ray.t_min = t_min;
        query.ray.t_max = t_max;
        require_agreement(fuzz::Case<T>(query));
        ++ranges;
      };
      ask(end, infinity);
      ask(-greatest, end);
      ask(end, end);
    }
  }
  return ranges;
}

/// On the first cases of every family; at least so many ranges.
template <template <class> class Query>
void require_agreement_around_family_answers(std::uint64_t cases_a_family, int least) {
  in_both_formats([&]<Real T>() {
    int ranges = 0;
    each_family_query<Query, T>(cases_a_family,
                                [&](const Query<T>& query) { ranges += require_agreement_around_answers<T>(query); });
    CHECK(ranges >= least);
  });
}

}  // namespace graze::test
