#include "fuzz/certify/row.hpp"

#include <algorithm>
#include <utility>

namespace graze::fuzz {

void Part::add(const Part& other) {
  tally.merge(other.tally);
  rays += other.rays;
  lost_rays += other.lost_rays;
  input_hash += other.input_hash;
}

void Row::cover(Part part) {
  if (part.range.from == part.range.to) return;
  auto next = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.range.from >= part.range.to; });
  if (next != parts.end() && next->range.from == part.range.to) {
    part.add(*next);
    part.range.to = next->range.to;
    next = parts.erase(next);
  }
  if (next != parts.begin() && std::prev(next)->range.to == part.range.from) {
    Part& before = *std::prev(next);
    before.add(part);
    before.range.to = part.range.to;
  } else {
    parts.insert(next, std::move(part));
  }
}

Part Row::total() const {
  Part sum;
  for (const Part& part : parts) sum.add(part);
  sum.range = {0, planned};
  return sum;
}

std::vector<Range> Row::gaps(Range within) const {
  std::vector<Range> open;
  for (const Part& part : parts) {
    if (part.range.to <= within.from) continue;
    if (part.range.from >= within.to) break;
    if (part.range.from > within.from) open.push_back({within.from, part.range.from});
    within.from = part.range.to;
  }
  if (within.from < within.to) open.push_back(within);
  return open;
}

}  // namespace graze::fuzz
