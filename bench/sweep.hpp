// A stability sweep: one condition, by powers of two.
#pragma once

#include <string_view>
#include <vector>

#include "bench/draws.hpp"
#include "fuzz/case.hpp"

namespace graze::bench {

template <class Query>
struct Sweep {
  std::string_view name;   ///< in results
  std::string_view title;  ///< on pages
  std::string_view axis;   ///< what 2^level is
  int first, last, step;   ///< levels
  /// The input errors grow by (2^level)^slope while a formula in one precision has digits left; 0: no theory.
  double slope;
  std::string_view theory;  ///< why, in a clause
  Query (*make)(int level, Draws&);
};

/// All numbers of a vector, or a shape's, moved or scaled.
inline Vec3<double> sum(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// Each coordinate times a power of two between 2^-spread and 1.
inline Vec3<double> spread_out(const Vec3<double>& a, int spread, Draws& draws) {
  const auto one = [&](double x) { return std::ldexp(x, -static_cast<int>(draws.fraction() * (spread + 1))); };
  const double x = one(a.x), y = one(a.y), z = one(a.z);
  return {x, y, z};
}

}  // namespace graze::bench
