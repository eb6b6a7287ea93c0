// near-tie. Needle triangles, E2 = E1 + a few lattice steps, with a ray that is nearly in their plane: the determinants are
// 2^-10 to 2^-40 of the products they are made of. Face hits whose t, u or v misses a midpoint of the format by 2^-(digits + 1)
// / q, where q is as large as the format lets the coordinates be. A candidate in twice the working precision errs by more than
// that, so it is the bound of its error that must send the case on to exact arithmetic.
#include "fuzz/families/constructions.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// v and a short step away from it.
IntVec beside(Random& random, const IntVec& v, int step_bits) {
  return v + choose_vector(random, step_bits);
}

/// A part strictly between 0 and whole; 1 where there is none.
Int choose_part(Random& random, Int whole) {
  return whole > 2 ? 1 + residue(choose_natural(random, 64), whole - 1) : 1;
}

/// t = tau / alpha beside a midpoint.
TriangleDraft distance_near_tie(Random& random, int digits) {
  const int direction_bits = random.between(2, digits / 6), part_bits = random.between(2, 4);
  const Quotient t = near_midpoint(random, digits - 2 - direction_bits, digits);
  const int edge_bits = digits - 3 - part_bits;
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = beside(random, aim.e1, random.between(1, edge_bits / 2));
  aim.point.q = choose_full(random, part_bits) + 2;
  aim.point.i = choose_part(random, aim.point.q - 1);
  aim.point.j = choose_part(random, aim.point.q - aim.point.i);
  aim.d = choose_vector(random, direction_bits);
  aim.tau = t.num;
  aim.alpha = t.den;
  return aimed_triangle(aim);
}

/// u or v = i / q beside a midpoint.
TriangleDraft coordinate_near_tie(Random& random, int digits) {
  const int part_bits = random.between(digits / 2, digits * 3 / 4);
  const int edge_bits = digits - 3 - part_bits;
  const Quotient u = near_midpoint(random, part_bits, digits);
  Aim aim;
  aim.e1 = choose_vector(random, edge_bits);
  aim.e2 = beside(random, aim.e1, random.between(1, 1 + edge_bits / 2));
  aim.point = {u.num, choose_part(random, u.den - u.num), u.den};
  if (random.one_in(2)) std::swap(aim.point.i, aim.point.j);
  // Nearly along an edge, and as long as the origin allows.
  const int factor_bits = choose_bits(random, 1, part_bits - 1);
  const Int factor = choose_full(random, factor_bits);
  aim.d = beside(random, factor * aim.e1, random.between(1, edge_bits));
  return aimed_triangle(aim);
}

struct NearTie {
  static constexpr std::string_view name = "near-tie";
  static constexpr std::string_view attacks = "t, u, v of needles beside midpoints, where determinants cancel";
  static constexpr Note note{"a bound too small for the error of a number in twice the working precision",
                             "t, u or v off by one ulp, once in very many hits",
                             "none seen; the promise that it holds is graze's own"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    Plan plan;
    plan.range = Range::never;
    plan.translate = false;
    const TriangleDraft draft =
        random.one_in(2) ? distance_near_tie(random, digits<T>) : coordinate_near_tie(random, digits<T>);
    return finish<T>(draft, random, index, plan);
  }
};

}  // namespace

Family near_tie_family() {
  return family_of<NearTie>();
}

}  // namespace graze::fuzz::construct
