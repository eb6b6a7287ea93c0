// degenerate. Triangles without area: corners at integer multiples of one lattice vector F, two or all three of them equal. The
// ray crosses the segment at a multiple of F (inside, at an end, one step beyond), runs along its line toward it, away from it
// or from within, runs parallel to it a unit aside, or passes it askew. A determinant is 0 for all of them, so kernels that
// only test the determinant call them parallel and miss; others divide by it.
#include <algorithm>

#include "fuzz/families/constructions.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// Corners at place[k] * F.
std::array<Int, 3> choose_places(Random& random, int bits) {
  std::array<Int, 3> place{};
  for (Int& p : place) p = choose_integer(random, bits);
  switch (random.below(4)) {
    case 0:
      place[2] = place[0];
      break;
    case 1:
      place[1] = place[2] = place[0];
      break;
    default:
      break;
  }
  return place;
}

}  // namespace

TriangleDraft degenerate_draft(Random& random, int digits) {
  const int place_bits = random.one_in(3) ? random.between(1, digits / 3) : random.between(1, 2);
  const int vector_bits = choose_bits(random, 1, digits - 4 - place_bits);
  const IntVec f = choose_vector(random, vector_bits);
  const std::array<Int, 3> place = choose_places(random, place_bits);
  const auto [low, high] = std::minmax_element(place.begin(), place.end());

  TriangleDraft draft;
  for (std::size_t k = 0; k < 3; ++k) draft.corner[k] = place[k] * f;

  Int at = choose_integer(random, place_bits);
  if (random.one_in(2)) at = place[random.below(3)];
  if (random.one_in(4)) at += random.sign();

  const int direction_bits = choose_bits(random, 1, digits - 4);
  const IntVec d = choose_vector(random, direction_bits);
  const int along_bits = choose_bits(random, 1, digits - 3 - direction_bits);
  const Int tau = choose_natural(random, along_bits);
  const Int alpha = choose_factor(random, digits - direction_bits);
  const IntVec aside = choose_vector(random, 1);
  const bool is_point = *low == *high;
  switch (random.below(6)) {
    case 0: {  // along the line
      const int sign = random.sign();
      const Int step = sign * random.between(1, 3);
      draft.origin = at * f;
      draft.direction = step * f;
      draft.promise = {TriangleKind::degenerate, two_marks(make_mark(*low - at, step), make_mark(*high - at, step))};
      break;
    }
    case 1:  // parallel, a unit aside
      draft.origin = at * f + aside;
      draft.direction = random.sign() * f;
      if (!is_zero(cross(f, aside))) draft.promise.kind = TriangleKind::miss;
      break;
    case 2:  // askew
      draft.origin = at * f - tau * d + aside;
      draft.direction = alpha * d;
      if (surely_independent(f, d, aside)) draft.promise.kind = TriangleKind::miss;
      break;
    default: {  // crossing
      draft.origin = at * f - tau * d;
      draft.direction = alpha * d;
      const bool hits = *low <= at && at <= *high;
      const bool is_crossing = !is_zero(cross(f, d));
      const Mark mark = make_mark(tau, alpha);
      if (is_crossing) draft.promise = {hits ? TriangleKind::degenerate : TriangleKind::miss, two_marks(mark, mark)};
      if (!is_crossing && is_point && hits) draft.promise = {TriangleKind::degenerate, two_marks(mark, mark)};
      break;
    }
  }
  return draft;
}

namespace {
struct Degenerate {
  static constexpr std::string_view name = "degenerate";
  static constexpr std::string_view attacks = "segments and points for triangles";
  static constexpr Note note{"a triangle without area divides by zero, or counts as a plane",
                             "a hit told for every ray, or none where the ray meets the segment",
                             "libgdx/libgdx issue 4901: true for any degenerate triangle"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.mixed_axes = index % 16 >= 12;
    return finish<T>(degenerate_draft(random, digits<T>), random, index, plan);
  }
};
}  // namespace

Family degenerate_family() {
  return family_of<Degenerate>();
}

}  // namespace graze::fuzz::construct
