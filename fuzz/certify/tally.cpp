#include "fuzz/certify/tally.hpp"

#include <algorithm>
#include <utility>

namespace graze::fuzz {

bool Tally::is_worse(const Comparison& c, std::uint64_t index, const Offender& than) {
  if (c.disagreement != than.comparison.disagreement) return c.disagreement > than.comparison.disagreement;
  if (c.error_ulps != than.comparison.error_ulps) return c.error_ulps > than.comparison.error_ulps;
  return index < than.index;
}

void Tally::keep(Offender offender) {
  const auto place = std::find_if(offenders.begin(), offenders.end(),
                                  [&](const Offender& kept) { return is_worse(offender.comparison, offender.index, kept); });
  offenders.insert(place, std::move(offender));
  if (offenders.size() > kept_offenders) offenders.pop_back();
}

void Tally::keep_oracle_difference(Offender offender, std::uint64_t index) {
  offender.comparison = {Disagreement::oracles, 0};
  offender.index = index;
  ++by_disagreement[static_cast<std::size_t>(Disagreement::oracles)];
  keep(std::move(offender));
}

void Tally::merge(const Tally& other) {
  cases += other.cases;
  skipped += other.skipped;
  for (std::size_t i = 0; i < by_disagreement.size(); ++i) by_disagreement[i] += other.by_disagreement[i];
  misrounded += other.misrounded;
  worst_ulps = std::max(worst_ulps, other.worst_ulps);
  oracles_compared += other.oracles_compared;
  for (const Offender& offender : other.offenders) keep(offender);
}

}  // namespace graze::fuzz
