// From a draft to a case: symmetry, translation, scale, range, nudge; and the label that is left of the promise.
#pragma once

#include <cstdint>

#include "fuzz/families/draft.hpp"
#include "fuzz/families/float_bits.hpp"
#include "fuzz/families/nudge.hpp"
#include "fuzz/families/scale.hpp"
#include "fuzz/family.hpp"

namespace graze::fuzz::construct {

enum class Range {
  sometimes,  ///< one case in eight has a range other than the default
  always,
  never,
};

/// How a family wants its drafts finished.
struct Plan {
  Reach reach = Reach::usual;
  Range range = Range::sometimes;
  bool translate = true;
  bool one_scale = false;           ///< directions get the scale of positions
  bool mixed_axes = false;          ///< exponents differ from axis to axis (an affine map: no sphere keeps its promise)
  std::optional<int> t_exponent{};  ///< see ScaleRequest
  bool is_pure = true;              ///< else one or two numbers are nudged, and the label is dropped
  Nudged nudged = Nudged::anything;
  int shared_position_bits = 0;  ///< cases that share a ray and a scale say the most digits of any of them
};

/// Every fourth case is pure.
[[nodiscard]] constexpr bool is_pure_index(std::uint64_t index) {
  return index % 4 == 0;
}

/// Families of both shapes alternate so that pure and nudged cases of both come up.
[[nodiscard]] constexpr bool is_triangle_index(std::uint64_t index) {
  return (index / 4) % 2 == 1;
}

/// Draws only as many numbers as the plan and the promise's marks determine, so cases that agree in them share their ray.
template <Real T>
[[nodiscard]] LabelledCase<T> finish(const Draft& draft, Random& random, const Plan& plan);

/// The same with the purity that the index gives.
template <Real T>
[[nodiscard]] LabelledCase<T> finish(const Draft& draft, Random& random, std::uint64_t index, Plan plan = {}) {
  plan.is_pure = is_pure_index(index);
  return finish<T>(draft, random, plan);
}

}  // namespace graze::fuzz::construct
