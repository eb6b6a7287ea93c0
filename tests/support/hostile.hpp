// Input that nobody should give: every number of a query replaced, alone and in pairs, by what is not finite, zero, negative or
// extreme.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz/case_numbers.hpp"
#include "tests/support/agreement.hpp"

namespace graze::test {

template <Real T>
[[nodiscard]] std::array<T, 13> hostile_numbers() {
  using Limits = std::numeric_limits<T>;
  const T nan = Limits::quiet_NaN(), infinity = Limits::infinity(), least = Limits::denorm_min(), greatest = Limits::max();
  return {nan,      -nan,     Limits::signaling_NaN(), infinity, -infinity, T(0.0), T(-0.0), T(1), T(-1), least, -least,
          greatest, -greatest};
}

/// The contract's order: non_finite, zero_direction, negative_radius, empty_range.
template <class Query>
[[nodiscard]] Status expected_status(const Query& query) {
  bool all_finite = true;
  fuzz::for_each_number(query, [&](const auto& x) {
    bool may_be_infinite = false;
    if constexpr (requires { query.ray; }) may_be_infinite = &x == &query.ray.t_max && x > 0;
    if (!std::isfinite(x) && !(may_be_infinite && std::isinf(x))) all_finite = false;
  });
  if (!all_finite) return Status::non_finite;
  if constexpr (requires { query.ray; }) {
    if (query.ray.direction.x == 0 && query.ray.direction.y == 0 && query.ray.direction.z == 0) return Status::zero_direction;
  }
  if constexpr (requires { query.sphere; }) {
    if (query.sphere.radius < 0) return Status::negative_radius;
  }
  if constexpr (requires { query.ray; }) {
    if (query.ray.t_min > query.ray.t_max) return Status::empty_range;
  }
  return Status::ok;
}

/// Calls visit(query) with one number and with two numbers of it replaced, in every way.
template <Real T, class Query, class Visit>
void each_hostile(const Query& base, Visit visit) {
  Query query = base;
  std::vector<T*> slots;
  fuzz::for_each_number(query, [&](T& x) { slots.push_back(&x); });
  for (T* first : slots) {
    const T first_before = *first;
    for (const T x : hostile_numbers<T>()) {
      *first = x;
      for (T* second : slots) {
        if (second < first) continue;
        const T second_before = *second;
        for (const T y : hostile_numbers<T>()) {
          *second = y;
          visit(query);
        }
        *second = second_before;
      }
    }
    *first = first_before;
  }
}

/// Every hostile query is answered, with its status, as by the oracle, in every environment; an invalid one with nothing but
/// its status.
template <Real T, class Query>
void require_hostile_agreement(const Query& base) {
  std::array<int, 5> met{};
  each_hostile<T>(base, [&](const Query& query) {
    const Status expected = expected_status(query);
    ++met[static_cast<std::size_t>(expected)];
    const fuzz::Case<T> input(query);
    require_agreement_in_all_environments(input);
    const Status found = std::visit([](const auto& answer) { return answer.status; }, fuzz::kernel_answer(input).answer);
    if (found == expected) return;
    INFO(sizeof(T) * 8 << " bits: " << fuzz::format_case(input));
    CAPTURE(static_cast<int>(found), static_cast<int>(expected));
    REQUIRE(found == expected);
  });
  CHECK(met[static_cast<std::size_t>(Status::ok)] > 100);
  CHECK(met[static_cast<std::size_t>(Status::non_finite)] > 100);
  if constexpr (requires { base.sphere; }) CHECK(met[static_cast<std::size_t>(Status::negative_radius)] > 10);
  if constexpr (requires { base.ray; }) CHECK(met[static_cast<std::size_t>(Status::empty_range)] > 10);
}

}  // namespace graze::test
