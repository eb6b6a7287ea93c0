#include "fuzz/report/merge.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "fuzz/report/json.hpp"
#include "fuzz/report/numbers.hpp"

namespace graze::fuzz {
namespace {

bool overlap(const Range& a, const Range& b) {
  return a.from < b.to && b.from < a.to;
}

bool holds(const Range& a, const Range& b) {
  return a.from <= b.from && b.to <= a.to;
}

/// A count of the part that is greater than that of the whole it is said to be in; empty where it fits. An offender of the part
/// is among those of the whole, unless it is behind them all.
std::string misfit(const Report& report, const Part& whole, const Part& part) {
  const Json all = to_json(report, whole, true), some = to_json(report, part, true);
  const Json counts = some.flatten();
  for (const auto& [path, count] : counts.items()) {
    if (!count.is_number_unsigned() || path.starts_with("/offenders")) continue;
    const Json::json_pointer place(path);
    const std::uint64_t limit = all.contains(place) ? all.at(place).get<std::uint64_t>() : 0;
    if (count.get<std::uint64_t>() > limit) {
      return path.substr(1) + ": " + std::to_string(limit) + " in the greater part and " + count.dump() + " in the lesser";
    }
  }
  if (part.tally.worst_ulps > whole.tally.worst_ulps) {
    return "worst_error_ulps: " + all.at("worst_error_ulps").dump() + " in the greater part and " +
           some.at("worst_error_ulps").dump() + " in the lesser";
  }
  Part again = whole;
  for (const Offender& offender : part.tally.offenders) {
    const auto same = [&](const Offender& o) {
      const auto key = [](const Offender& x) {
        return std::tie(x.index, x.mode, x.comparison.disagreement, x.comparison.error_ulps, x.input, x.answer, x.truth);
      };
      return key(o) == key(offender);
    };
    if (std::any_of(whole.tally.offenders.begin(), whole.tally.offenders.end(), same)) continue;
    Tally one;
    one.offenders = {offender};
    again.tally.merge(one);
  }
  return first_difference(all, to_json(report, again, true));
}

/// Adds a part to a row.
std::string add(const Report& report, Row& row, const Part& part) {
  std::vector<Part>& parts = row.parts;
  const auto name = [&] { return row.name + ", " + row.precision + ", " + text_of(part.range) + ": "; };
  const auto first = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return overlap(p.range, part.range); });
  const auto last = std::find_if(first, parts.end(), [&](const Part& p) { return !overlap(p.range, part.range); });
  if (first == last) {
    const auto after = [&](const Part& p) { return p.range.from >= part.range.to; };
    parts.insert(std::find_if(parts.begin(), parts.end(), after), part);
    return {};
  }
  if (first->range == part.range) {
    const std::string difference = first_difference(to_json(report, *first, true), to_json(report, part, true));
    return difference.empty() ? "" : name() + difference;
  }
  if (holds(first->range, part.range)) {
    const std::string difference = misfit(report, *first, part);
    return difference.empty() ? "" : name() + difference;
  }
  if (!std::all_of(first, last, [&](const Part& p) { return holds(part.range, p.range); })) {
    return name() + "overlap " + text_of(first->range) + " of another split, so the two cannot be added";
  }
  Part sum;
  for (auto p = first; p != last; ++p) sum.add(*p);
  if (const std::string difference = misfit(report, part, sum); !difference.empty()) return name() + difference;
  *first = part;
  parts.erase(first + 1, last);
  return {};
}

}  // namespace

std::string merge(Report& report, const Report& other) {
  if (std::string difference = first_difference(identity(report), identity(other)); !difference.empty()) return difference;
  Report sum = report;
  sum.cpus.insert(other.cpus.begin(), other.cpus.end());
  sum.shards.insert(other.shards.begin(), other.shards.end());
  // Without shards a report is one of the whole campaign.
  if (report.shards.empty() || other.shards.empty()) sum.shards.clear();
  for (std::size_t i = 0; i < sum.rows.size(); ++i) {
    Row& row = sum.rows[i];
    for (const Part& part : other.rows[i].parts) {
      if (std::string wrong = add(sum, row, part); !wrong.empty()) return wrong;
    }
    if (row.is_whole() && row.planned != 0) row.parts = {row.total()};
  }
  if (sum.is_whole()) sum.shards.clear();
  report = std::move(sum);
  return {};
}

std::string missing(const Report& report) {
  if (report.is_whole()) return {};
  const auto count = report.shards.empty() ? 0 : report.shards.begin()->count;
  const bool one_split =
      std::all_of(report.shards.begin(), report.shards.end(), [&](const Shard& s) { return s.count == count; });
  std::string names;
  for (std::uint64_t number = 1; one_split && number <= count; ++number) {
    const Shard shard{number, count};
    const bool has_gap = std::any_of(report.rows.begin(), report.rows.end(),
                                     [&](const Row& row) { return !row.gaps(shard.of(row.planned)).empty(); });
    if (has_gap) names += (names.empty() ? "" : ", ") + text_of(shard) + (report.shards.contains(shard) ? " (begun)" : "");
  }
  if (!names.empty()) return "shards " + names;
  const auto row = std::find_if(report.rows.begin(), report.rows.end(), [](const Row& r) { return !r.is_whole(); });
  const std::vector<Range> gaps = row->gaps({0, row->planned});
  for (std::size_t i = 0; i < std::min<std::size_t>(gaps.size(), 3); ++i) names += (i == 0 ? "" : ", ") + text_of(gaps[i]);
  const auto others = std::count_if(row + 1, report.rows.end(), [](const Row& r) { return !r.is_whole(); });
  return names + (gaps.size() > 3 ? ", ..." : "") + " of " + row->name + ", " + row->precision +
         (others == 0 ? "" : ", and parts of " + std::to_string(others) + " more rows");
}

}  // namespace graze::fuzz
