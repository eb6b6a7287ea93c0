# The widths of integers in steps of a lattice (src/numeric/lattice.hpp), in any rounding mode: u = 2^-52.
#
# `sum` is a sum of magnitudes, computed in up to 16 roundings (the differences' own included, until they are known to be exact); a step is
# above 2^-54 lattice_fineness sum. So what is summed is below R steps in all, R = 2^54 / lattice_fineness up to those roundings.
#
# Proved: a product of two such numbers, or a sum of products whose factors add to R at most on either side, is below 2^63: the components of
# cross products, and A, B and C of a sphere. Three times the product of three, and that of four, are below 2^127: a triangle's
# determinants and w; B^2 and A C. And R is below 2^53: differences of multiples of the step are without error, for a difference
# of 2^53 steps or more would by itself make the computed sum too large.
#
# Left to say: the components of a x b are at most |a||b|, with |.| sums of magnitudes; the scripts' sums are those of E1, E2 and T, of L and
# r, of d. A power of two times a number is without error at these exponents.
lattice_fineness = 1b23;    # bound: src/numeric/lattice.hpp
u = 1b-52;
R = 1b54 / (lattice_fineness * (1 + F * u));

{ |F| <= 17 -> R * R / (1b63 - 1) in [0, 1] }
{ |F| <= 17 -> 3 * R * R * R / (1b127 - 1) in [0, 1] /\ R * R * R * R / (1b127 - 1) in [0, 1] }
{ |F| <= 17 -> R / (1b53 - 1) in [0, 1] }
