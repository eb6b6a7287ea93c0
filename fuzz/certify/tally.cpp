#include "fuzz/certify/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace graze::fuzz {
namespace {

/// The worse comes first, then the lower index; the texts part cases of one index, such as the triangles around a corner, so
/// that the order of merging never decides.
bool comes_before(const Offender& a, const Offender& b) {
  const auto key = [](const Offender& o) {
    return std::make_tuple(-static_cast<int>(o.comparison.disagreement), -o.comparison.error_ulps, o.index);
  };
  const auto texts = [](const Offender& o) { return std::tie(o.precision, o.mode, o.input, o.answer); };
  return key(a) != key(b) ? key(a) < key(b) : texts(a) < texts(b);
}

}  // namespace

std::size_t error_bin(double ulps) {
  if (!(ulps < std::numeric_limits<double>::infinity())) return error_bins - 1;
  if (ulps < 1) return ulps > 0 ? 1 : 0;
  return static_cast<std::size_t>(std::min(std::ilogb(ulps), 63)) + 2;
}

std::uint64_t Tally::wrong_kinds() const {
  std::uint64_t n = 0;
  for (const Disagreement d : {Disagreement::invalid_handling, Disagreement::wrong_detail, Disagreement::wrong_order,
                               Disagreement::wrong_kind, Disagreement::false_hit, Disagreement::lost_hit}) {
    n += count(d);
  }
  return n;
}

bool Tally::is_clean() const {
  return std::all_of(by_disagreement.begin() + 1, by_disagreement.end(), [](std::uint64_t n) { return n == 0; });
}

void Tally::count_in(const Comparison& c) {
  ++answers;
  ++by_disagreement[static_cast<std::size_t>(c.disagreement)];
  for (std::size_t i = 0; i < deviation_count; ++i) {
    if (c.allowed.has(static_cast<Deviation>(i))) ++by_deviation[i];
  }
  if (c.has_numbers) ++by_error[error_bin(c.error_ulps)];
  if (c.error_ulps > 0) ++misrounded;
  worst_ulps = std::max(worst_ulps, c.error_ulps);
}

bool Tally::is_behind(const Comparison& c, std::uint64_t index, const Offender& kept) {
  if (c.disagreement != kept.comparison.disagreement) return c.disagreement < kept.comparison.disagreement;
  if (c.error_ulps != kept.comparison.error_ulps) return c.error_ulps < kept.comparison.error_ulps;
  return index > kept.index;
}

void Tally::keep(Offender offender) {
  const auto place = std::upper_bound(offenders.begin(), offenders.end(), offender, comes_before);
  offenders.insert(place, std::move(offender));
  if (offenders.size() > kept_offenders) offenders.pop_back();
}

void Tally::keep_oracle_difference(Offender offender, std::uint64_t index) {
  offender.comparison = {};
  offender.comparison.disagreement = Disagreement::oracles;
  offender.index = index;
  ++by_disagreement[static_cast<std::size_t>(Disagreement::oracles)];
  keep(std::move(offender));
}

void Tally::merge(const Tally& other) {
  const auto add_up = [](auto& to, const auto& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
  };
  answers += other.answers;
  skipped += other.skipped;
  add_up(by_disagreement, other.by_disagreement);
  add_up(by_deviation, other.by_deviation);
  add_up(by_error, other.by_error);
  misrounded += other.misrounded;
  worst_ulps = std::max(worst_ulps, other.worst_ulps);
  oracles_compared += other.oracles_compared;
  for (const Offender& offender : other.offenders) keep(offender);
}

}  // namespace graze::fuzz
