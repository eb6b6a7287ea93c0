// A draft: a case on the integer lattice, with what its construction promises, before it is scaled to a format.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "fuzz/families/choose.hpp"
#include "fuzz/families/integer.hpp"
#include "graze/answer.hpp"

namespace graze::fuzz::construct {

/// A parameter num / den of the ray, in lattice units; den > 0.
struct Mark {
  Int num = 0, den = 1;
};
[[nodiscard]] constexpr Mark make_mark(Int num, Int den) {
  return den < 0 ? Mark{-num, -den} : Mark{num, den};
}

/// Up to two parameters, in any order.
struct Marks {
  std::array<Mark, 2> at{};
  int count = 0;
};
[[nodiscard]] constexpr Marks one_mark(Mark mark) {
  return {{mark, {}}, 1};
}
[[nodiscard]] constexpr Marks two_marks(Mark first, Mark second) {
  return {{first, second}, 2};
}

/// What is promised. `kind` is that of the whole line, and the marks are where it meets the shape (the point; both roots;
/// both ends of the common part): the kind within a range follows. A miss may have a mark for a range to aim at. Where the
/// marks are unknown (irrational roots), `kind` is that of the ray with t >= 0 and no upper end only.
template <class Kind>
struct Promise {
  std::optional<Kind> kind;
  Marks marks;
  bool forward_only = false;
};
template <class Kind>
[[nodiscard]] constexpr Promise<Kind> forward_promise(Kind kind) {
  return {kind, {}, true};
}

struct SphereDraft {
  IntVec origin, direction, center;
  Int radius = 0;
  Promise<SphereKind> promise;
};

struct TriangleDraft {
  IntVec origin, direction;
  std::array<IntVec, 3> corner;
  Promise<TriangleKind> promise;
};

using Draft = std::variant<SphereDraft, TriangleDraft>;

/// Calls f on every position (not on the direction).
template <class F>
void each_position(SphereDraft& draft, F f) {
  f(draft.origin);
  f(draft.center);
}
template <class F>
void each_position(TriangleDraft& draft, F f) {
  f(draft.origin);
  for (IntVec& corner : draft.corner) f(corner);
}

/// Turns the direction around: t becomes -t. A promise for t >= 0 is lost.
template <class AnyDraft>
void reverse(AnyDraft& draft) {
  draft.direction = -draft.direction;
  if (draft.promise.forward_only) draft.promise = {};
  for (Mark& mark : draft.promise.marks.at) mark.num = -mark.num;
}

/// The digits that the positions need, the radius included.
[[nodiscard]] int position_bits(const SphereDraft& draft);
[[nodiscard]] int position_bits(const TriangleDraft& draft);

/// Permutes and reflects the axes: every promise stays.
template <class AnyDraft>
void apply_symmetry(AnyDraft& draft, Random& random) {
  static constexpr int permutations[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const auto& permutation = permutations[random.below(6)];
  const std::uint64_t flips = random.bits();
  const auto apply = [&](IntVec& v) {
    IntVec moved;
    for (int axis = 0; axis < 3; ++axis)
      moved[axis] = ((flips >> axis) & 1) != 0 ? -v[permutation[axis]] : v[permutation[axis]];
    v = moved;
  };
  apply(draft.direction);
  each_position(draft, apply);
}

/// Moves everything by one lattice vector, as far as the positions stay within so many digits.
template <class AnyDraft>
void apply_translation(AnyDraft& draft, Random& random, int position_digits, int format_digits) {
  if (position_digits >= format_digits) return;
  const int length = choose_bits(random, 1, format_digits - 1);
  const IntVec offset = choose_vector(random, length);
  each_position(draft, [&](IntVec& v) { v = v + offset; });
}

/// The kind of a point on the feature opposite to corner 0, 1, 2 (an edge), or at it (a vertex).
[[nodiscard]] TriangleKind opposite_edge(int corner);
[[nodiscard]] TriangleKind vertex(int corner);

/// Permutes the corners, and the promised kind with them.
void permute_corners(TriangleDraft& draft, Random& random);

}  // namespace graze::fuzz::construct
