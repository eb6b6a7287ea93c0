# f(p) of lines, planes and spheres (graze/predicates/implicit_filter.hpp), in double.
#
# A product of a line's form goes through one rounding and two of sums, of a plane's through three; the constant through one. A component of
# a sphere's L is a rounded difference, twice in its square, which is rounded once and in two sums, and f once more: six; r^2 once and f.
# So the form errs by 3, 4 or 6 roundings of the sum of magnitudes; the bound is computed in five, six and five roundings or fewer.
#
# What underflows: an input read as zero costs its size, at most 2^-1022 (float: 2^-126), times the other factor, so the sum of all
# factors' magnitudes and 1 for the constant; in double at most 3 products, 3 sums and the bound's own product are flushed, 2^-1022 each.
# With I = 1 + the sum of the factors' magnitudes, 9 * 2^-1022 I (float: (1 + 2^-20) 2^-126 I) covers it, and I is computed in at most 7
# roundings, reading as zero what is 7 * 2^-126 of it at most.
#
# Left to say: the terms' magnitudes add to the sum of magnitudes. For the sphere's range see sphere_filter.g.
line_error = 4b0;             # bound: graze/predicates/implicit_filter.hpp
plane_error = 5b0;            # bound: graze/predicates/implicit_filter.hpp
sphere_c_error = 7b0;         # bound: graze/predicates/sphere_filter.hpp
double_underflow = 1b-1018;   # bound: graze/predicates/implicit_filter.hpp
float_underflow = 1b-125;     # bound: graze/predicates/implicit_filter.hpp
u = 1b-52;

{ |F3| <= 49155b-14 /\ |F5| <= 81925b-14 -> |F3 / (line_error * (1 + F5 * u))| <= 1 }
{ |F4| <= 65540b-14 /\ |F6| <= 98310b-14 -> |F4 / (plane_error * (1 + F6 * u))| <= 1 }
{ |F6| <= 98310b-14 /\ |F5| <= 81925b-14 /\ |H| <= 1b-16 -> |(F6 + H) / (sphere_c_error * (1 + F5 * u))| <= 1 }
{ |F7| <= 114695b-14 /\ h in [0, 7b-126] -> 9b-1022 / (double_underflow * (1 + F7 * u) * (1 - h)) in [0, 1] }
{ |F7| <= 114695b-14 /\ h in [0, 7b-126] -> 1b-126 * (1 + 1b-20) / (float_underflow * (1 + F7 * u) * (1 - h)) in [0, 1] }
