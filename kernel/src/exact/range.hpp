// The ray's range, exact: bounds as dyadic numbers, compared with exact values before any rounding.
#pragma once

#include "numeric/rounding.hpp"

namespace graze::exact {

using numeric::Dyadic;
using numeric::Format;

/// t_min <= t <= t_max, or without an upper end.
struct Range {
  Dyadic t_min, t_max;
  bool has_upper_end = false;

  template <class Value>
  [[nodiscard]] bool starts_after(const Value& t) const noexcept {
    return numeric::compare(t, t_min) < 0;
  }
  template <class Value>
  [[nodiscard]] bool ends_before(const Value& t) const noexcept {
    return has_upper_end && numeric::compare(t, t_max) > 0;
  }
  template <class Value>
  [[nodiscard]] bool contains(const Value& t) const noexcept {
    return !starts_after(t) && !ends_before(t);
  }
};

template <Real T>
[[nodiscard]] inline Range range(T t_min, T t_max) noexcept {
  if (!numeric::is_finite(t_max)) return {numeric::dyadic(t_min), {}, false};
  return {numeric::dyadic(t_min), numeric::dyadic(t_max), true};
}

}  // namespace graze::exact
