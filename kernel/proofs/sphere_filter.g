# The terms of a sphere's quadratic and its discriminant in both forms (graze/predicates/sphere_filter.hpp).
#
# All is divided by powers of sqrt(A) = |d| and sqrt(c_size), c_size = L.L + r^2, which is what the exact values are measured by: a = 1,
# |b| <= 1 (Cauchy and Schwarz), |c| <= 1, D = b^2 - c. A rounding of a sum is shared out to the terms in it. F is of k roundings, H of
# underflow, flush-to-zero and denormals-are-zero, in units; A and c_size lie in [low^2, high^2].
#
# Proved, in this order: the H are below 2^-16 and nothing overflows; A errs by 3 roundings, B by 4, C by 6 (L twice, the square, two sums,
# the difference), and C's bound covers that as computed; D's first form errs by less than its bound as computed, in 10 roundings; the second
# form, in double, likewise: a component X of d x L has two monomials of 3 roundings, which are in magnitude at most |d||L| (Cauchy and
# Schwarz), so its error x is at most perpendicular_error sqrt(A c_size); A r^2 errs by 5 roundings of itself, the squares and sums of |X|^2
# by 3, and the subtraction by 1 of both; |X|^2 - |X'|^2 is at most 2 x |X'|_1 + 3 x^2. A number is placed by two forms whose bounds cover them.
#
# Left to say: sums of terms are at most the sums of their magnitudes; |X'|_1 and x are computed as the code does.
sphere_c_error = 7b0;              # bound: graze/predicates/sphere_filter.hpp
sphere_discriminant_error = 24b0;  # bound: graze/predicates/sphere_filter.hpp
sphere_perpendicular_error = 4b0;  # bound: graze/predicates/sphere_filter.hpp
sphere_refined_error = 7b0;        # bound: graze/predicates/sphere_filter.hpp
sphere_place_error = 8b0;          # bound: graze/predicates/sphere_filter.hpp
double_low = 1b-200;               # domain: graze/numeric/filter.hpp
double_high = 1b200;               # domain: graze/numeric/filter.hpp
double_bound_high = 1b100;         # domain: graze/numeric/filter.hpp
mixed_low = 1b-40;                 # domain: graze/numeric/filter.hpp
mixed_high = 1b128;                # domain: graze/numeric/filter.hpp
mixed_bound_high = 1b100;          # domain: graze/numeric/filter.hpp
float_low = 1b-20;                 # domain: graze/numeric/filter.hpp
float_high = 1b30;                 # domain: graze/numeric/filter.hpp
float_bound_high = 1b30;           # domain: graze/numeric/filter.hpp
u = 1b-52;                         # and 1b-23

db = DB * u; dc = DC * u; f3 = F3 * u; g2 = G2 * u; k2 = K2 * u; h = H * u;

# In double, of double's own inputs and of floats read as zero (r^2 too); in float.
{ 3b-1022 / (double_low / 2) in [0, 1b-82] /\ 8b-1022 / (double_low * double_low * double_low * double_low / 16) in [0, 1b-120]
/\ 2b-126 / (mixed_low / 2) in [0, 1b-82] /\ 2b-252 / (mixed_low * mixed_low / 4) in [0, 1b-120]
/\ 8b-1022 / (mixed_low * mixed_low * mixed_low * mixed_low / 16) in [0, 1b-120] }
{ 3b-126 / (float_low / 2) in [0, 1b-82] /\ 8b-126 / (float_low * float_low * float_low * float_low / 4) in [0, 1b-41] }
{ double_high * double_high * double_high * double_high * 64 in [0, 1b1000] /\ double_high * double_high * double_bound_high * double_bound_high * 64 in [0, 1b1000]
/\ mixed_high * mixed_high * mixed_high * mixed_high * 64 in [0, 1b1000] /\ mixed_high * mixed_high * mixed_bound_high * mixed_bound_high * 64 in [0, 1b1000]
/\ float_high * float_high * float_high * float_high * 64 in [0, 1b127] /\ float_high * float_high * float_bound_high * float_bound_high * 64 in [0, 1b127] }

# C: six roundings of its terms, its bound in 5.
{ |F6| <= 98310b-14 /\ |H| <= 1b-16 /\ |F5| <= 81925b-14 -> |(F6 + H) / (sphere_c_error * (1 + F5 * u))| <= 1 }

# D = b^2 - a c from B = b + 4 roundings of 1, A = 1 + 3 of them, C = c + 6; three more roundings. c_size is computed in 5, A in 3, and the
# bound itself in 2 more.
{ |b| <= 1 /\ |c| <= 1 /\ |DB| <= 65541b-14 /\ |F3| <= 49156b-14 /\ |DC| <= 98311b-14 /\ |G2| <= 32770b-14 /\ |K2| <= 32770b-14
/\ |F10| <= 163850b-14 /\ |H| <= 1b-16 ->
   |((2 * b * db + db * db) * (1 + g2) + b * b * g2 - (dc + f3 * c + f3 * dc) * (1 + k2) - c * k2 + h) / u
     / (sphere_discriminant_error * (1 + F10 * u))| <= 1 }

# The second form. x: three roundings of |d||L| <= 1, against the code's perpendicular_error sqrt(A c_size) in 7; 2 x |X'|_1 in 6 more, and
# 3 x^2, which pays for r read as zero and squares flushed too: K, of S.
{ |F3| <= 49156b-14 /\ |H| <= 1b-16 /\ |F7| <= 114695b-14 /\ |F6| <= 98310b-14 ->
   |(F3 + H) / (sphere_perpendicular_error * (1 + F7 * u) * (1 + F6 * u))| <= 1 }
{ |F3| <= 49156b-14 /\ |H| <= 1b-16 /\ |F7| <= 114695b-14 /\ |F6| <= 98310b-14 /\ |K| <= 1b-12 ->
   (3 * (F3 + H) * (F3 + H) + K) / (3 * sphere_perpendicular_error * sphere_perpendicular_error * (1 + F7 * u) * (1 + F7 * u) * (1 + F6 * u)) in [-1, 1] }
# Of A r^2 and of |X'|^2 as computed: what they were, and what the subtraction makes of them. The bound takes 3 roundings.
{ |F5| <= 81926b-14 /\ |E| <= 1 /\ |G3| <= 49155b-14 ->
   |(E + (1 - 1 / (1 + F5 * u)) / u) / (sphere_refined_error * (1 + G3 * u))| <= 1 }
{ |F3| <= 49156b-14 /\ |E| <= 1 /\ |G3| <= 49155b-14 ->
   |(E + (1 - 1 / (1 + F3 * u)) / u) / (sphere_refined_error * (1 + G3 * u))| <= 1 }

# f = (a x - 2 b) x + c and g = a x - b at a number x: A's term has 3 roundings and 4 more, B's 4 and 3, C's 6 and 1; the sum of magnitudes
# is computed in 10.
{ |F7| <= 114696b-14 /\ |H| <= 1b-16 /\ |F10| <= 163850b-14 -> |(F7 + H) / (sphere_place_error * (1 + F10 * u))| <= 1 }

# Where |C| as computed exceeds its bound, |C| exceeds half a unit of c_size. So where C > 0 and D > 0, B^2 > A C > unit / 2 of A c_size, and B,
# which errs by 4 roundings, has its sign right.
{ |F6| <= 98311b-14 /\ |F5| <= 81925b-14 -> sphere_c_error * (1 + F5 * u) - F6 >= 1b-1 }
{ |DB| <= 65541b-14 -> DB * DB * u in [0, 1b-1] }
