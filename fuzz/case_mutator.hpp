// Changes of a case that a fuzzer would hardly find among its bytes: they know what a ray is.
#pragma once

#include <array>

#include "fuzz/case.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz {

enum class Mutation {
  nudge,     ///< one or two numbers moved by an ulp
  copy,      ///< a number becomes another one of the case
  negate,    ///< a number's sign turned
  simplify,  ///< a number becomes a small integer
  scale,     ///< all numbers, or the direction's, times a power of two
  permute,   ///< the axes or the corners permuted, an axis reflected, or the direction turned around
  aim,       ///< the direction becomes the way from the origin to a feature of the shape: a corner, an edge, the limb
  start,     ///< the origin put at a feature of the shape, or one or two directions before it
  touch,     ///< the ray made tangent to its sphere or put into its triangle's plane, the point put onto its surface
  collapse,  ///< the third corner put onto the line of the others, or the radius made zero
  bound,     ///< an end of the range put where the ray hits, by the kernel's answer
};
inline constexpr std::array mutations{Mutation::nudge, Mutation::copy,     Mutation::negate, Mutation::simplify,
                                      Mutation::scale, Mutation::permute,  Mutation::aim,    Mutation::start,
                                      Mutation::touch, Mutation::collapse, Mutation::bound};

/// Makes that change; false, and no change, where the case has nothing to change so. What is computed is rounded, so a touch
/// is exact for small integers and off by an ulp or so for full mantissas.
template <Real T>
bool mutate(Case<T>& input, Mutation mutation, Random& random);

/// Makes one change, of any sort that the case allows.
template <Real T>
void mutate(Case<T>& input, Random& random);

}  // namespace graze::fuzz
