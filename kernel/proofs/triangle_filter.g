# The determinants of TriangleTerms and what the verdict makes of them (graze/predicates/triangle_filter.hpp).
#
# A determinant is a sum of six monomials x y z of components of three vectors, two or (`distance`) three of them rounded differences.
# X, Y, Z are what is computed of the components, divided by |d|, s = |E1| + |E2| or, for T, r = |T| + s: x = (X - h0) / (1 + e0), and so on. A
# rounding of a sum is shared out to the monomials in it, so each is computed as
#   (((X Y (1 + e3) + h3) (1 + e4) + h4) Z (1 + e5) + h5) (1 + e6) (1 + e7), in w and in f = t - x whole with two roundings more.
# |d|, s and r lie in [low, high] of a format; the e are roundings, F those of k of them, the h underflow, flush-to-zero and
# denormals-are-zero.
#
# Proved, in this order: the h are below 2^-30 units and nothing overflows; a monomial's error of the h alone is less than 2^-26 units; that
# and its relative error, of five roundings and two more against two or three, are at most triangle_error, as the bound is computed in 14
# roundings.
#
# Left to say: with |.| sums of magnitudes, the six monomials' add to at most |d||E1||E2|, |T||d||E2|, |d||T||E1|, |T||E1||E2|; the first
# three, and their sum, which w has, to at most |d| (|E1||E2| + |T| s) < |d| s r, the last to less than s s r.
triangle_error = 10b0;     # bound: graze/predicates/triangle_filter.hpp
double_low = 1b-200;       # domain: graze/numeric/filter.hpp
double_high = 1b200;       # domain: graze/numeric/filter.hpp
double_bound_high = 1b100; # domain: graze/numeric/filter.hpp
mixed_low = 1b-40;         # domain: graze/numeric/filter.hpp
mixed_high = 1b128;        # domain: graze/numeric/filter.hpp
mixed_bound_high = 1b100;  # domain: graze/numeric/filter.hpp
float_low = 1b-20;         # domain: graze/numeric/filter.hpp
float_high = 1b30;         # domain: graze/numeric/filter.hpp
float_bound_high = 1b30;   # domain: graze/numeric/filter.hpp
u = 1b-52;                 # and 1b-23

h0 = H0 * u; h1 = H1 * u; h2 = H2 * u; h3 = H3 * u; h4 = H4 * u; h5 = H5 * u;

# In double, of double's own inputs and of floats read as zero; in float.
{ 3b-1022 / (double_low / 2) in [0, 1b-82] /\ 1b-1022 / (double_low * double_low * double_low / 8) in [0, 1b-82]
/\ 2b-126 / (mixed_low / 2) in [0, 1b-82] /\ 1b-1022 / (mixed_low * mixed_low * mixed_low / 8) in [0, 1b-82] }
{ 3b-126 / (float_low / 2) in [0, 1b-53] /\ 1b-126 / (float_low * float_low * float_low / 8) in [0, 1b-53] }
{ double_high * double_high * double_high * double_bound_high * 64 in [0, 1b1000]
/\ mixed_high * mixed_high * mixed_high * mixed_bound_high * 64 in [0, 1b1000] /\ float_high * float_high * float_high * float_bound_high * 64 in [0, 1b127] }

# computed - X Y Z (1 + e3) ... (1 + e7), and X Y Z - (X - h0) (Y - h1) (Z - h2).
{ |X| <= 1 /\ |Y| <= 1 /\ |Z| <= 1 /\ |H0| <= 1b-30 /\ |H1| <= 1b-30 /\ |H2| <= 1b-30 /\ |H3| <= 1b-30 /\ |H4| <= 1b-30 /\ |H5| <= 1b-30
/\ |E4| <= 1 /\ |E5| <= 1 /\ |F2| <= 32770b-14 /\ |F3| <= 49155b-14 ->
   |(((h3 * (1 + E4 * u) + h4) * Z * (1 + E5 * u) + h5) * (1 + F2 * u) + (h0 * (Y - h1) * (Z - h2) + X * h1 * (Z - h2) + X * Y * h2) / (1 + F3 * u)) / u| <= 1b-26 }

# w, and f as far as x whole goes; f as far as the distance goes. Six monomials' underflow is added.
{ |F7| <= 114695b-14 /\ |F2| <= 32770b-14 /\ |F14| <= 229390b-14 /\ |H| <= 6b-26 ->
   |(F7 + (1 - 1 / (1 + F2 * u)) / u + H) / (triangle_error * (1 + F14 * u))| <= 1 }
{ |F6| <= 98310b-14 /\ |F3| <= 49155b-14 /\ |F14| <= 229390b-14 /\ |H| <= 6b-26 ->
   |(F6 + (1 - 1 / (1 + F3 * u)) / u + H) / (triangle_error * (1 + F14 * u))| <= 1 }
