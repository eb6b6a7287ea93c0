# The roots of a sphere's quadratic (src/rounding/roots.cpp), in rounding to nearest: v = 2^-53, E its roundings in that unit. What P, X, Y
# and the steps are, see face.g. S = A c_size; sqrt(S) = 1 or written out as rho = sqrt(S) / |q| and sigma = sqrt(S) / s, s = sqrt(D).
#
# For double, A errs by 8.01 v^2 A, B by 15.02 v^2 sqrt(S), C by 24.03 v^2 c_size and D by 181.2 v^2 S, low parts are below 3.002 v A,
# 4.003 v sqrt(S) and, before C and D are normalised, 5.003 v c_size. D > certainty * its error makes s >= 2^-44 sqrt(S) and rho, sigma <=
# 2^44, and with |q| >= s (nothing cancels) rho <= sigma, 1 <= sigma. So q's low part is below (2.51 + 4.01 rho) v |q| <= 2^-6 |q|, and sizes
# taken from high parts, of q and of the root, are right up to 1.04 together.
#
# Proved, step by step: these; the root of D errs by 5.8 v^2 s in its steps and by D's error / (2 s), up to root_share; q by its parts and
# by (1.001 |q| + 8.01 sqrt(S) + 3.01 s) v^2; q / A and C / q by their parts and by what divide() does; all of it, with the rounding test's room
# v times the low part, is within the bounds of roots(): pair_steps for what is relative to the root and for what is rho times it, and D's error
# for rho sigma. For float A errs by 3 v, B by 4 v sqrt(S), and pairs add less than 2^-40 v to that.
#
# Left to say: errors add, relative ones to first order; the second is below 2^-40 of it, and rounded away here.
certainty = 1b10;                      # bound: src/rounding/error_bounds.hpp
root_share = 1b-11;                    # bound: src/rounding/error_bounds.hpp
pair_steps = 1b-99;                    # bound: src/rounding/error_bounds.hpp
pair_c_error = 1b-101;                 # bound: src/rounding/error_bounds.hpp
pair_discriminant_error = 1b-98;       # bound: src/rounding/error_bounds.hpp
double_steps = 1b-50;                  # bound: src/rounding/error_bounds.hpp

v = 1b-53;
p = P * v; x = X * v; y = Y * v; r = R * v;
e1 = E1 * v; e2 = E2 * v; f2 = F2 * v; f3 = F3 * v; f4 = F4 * v; f5 = F5 * v;
T = sqrt(1 + r);

# A: two products added; two such sums.
{ |P| <= 1.0001 /\ |X| <= 1.0001 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 3.001 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 2.001 }
{ |P| <= 1.0001 /\ |X| <= 2.0011 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 5.003 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 3.002 }
# B: a number times a difference, 3.001 and 2.001 as above; two of these added, 5.003 and 3.002; two such sums.
{ |P| <= 1.0001 /\ |X| <= 3.0021 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 7.005 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 4.003 }
# C: a product of two differences; two of these added; two such sums.
{ |P| <= 1.0001 /\ |X| <= 1.0001 /\ |Y| <= 1.0001 /\ |E1| <= 1 /\ |F2| <= 2.0001 ->
   |(p * e1 + (x + y) * (f2 + e1 + f2 * e1) - x * y) / (v * v)| <= 8.01 /\ |((p + (x + y) * (1 + f2)) * (1 + e1)) / v| <= 3.001 }
{ |P| <= 1.0001 /\ |X| <= 3.0011 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 7.003 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 4.002 }
{ |P| <= 1.0001 /\ |X| <= 4.0021 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 9.005 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 5.003 }
# 8.01 + 7.003 + 9.005, of c_size as SphereTerms computes it and to first order in 1 / |q|, of which the high part is taken.
{ |F| <= 32 -> 24.03 * 1.04 * v * v / (pair_c_error * (1 + F * v)) in [0, 1] }

# D: B^2 and A C, both at most S; their difference.
{ |P| <= 1.0001 /\ |X| <= 4.0031 /\ |Y| <= 4.0031 /\ |E1| <= 1 /\ |F2| <= 2.0001 ->
   |(p * e1 + (x + y) * (f2 + e1 + f2 * e1) - x * y) / (v * v)| <= 41.052 /\ |((p + (x + y) * (1 + f2)) * (1 + e1)) / v| <= 9.007 }
{ |P| <= 1.0001 /\ |X| <= 3.0021 /\ |Y| <= 5.0031 /\ |E1| <= 1 /\ |F2| <= 2.0001 ->
   |(p * e1 + (x + y) * (f2 + e1 + f2 * e1) - x * y) / (v * v)| <= 40.044 /\ |((p + (x + y) * (1 + f2)) * (1 + e1)) / v| <= 9.007 }
{ |P| <= 2.0001 /\ |X| <= 18.0141 /\ |E1| <= 1 /\ |E2| <= 1 -> |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 38.04 }
# B and A, C as they come in: 2 * 15.02 and 8.01 + 24.03.
{ |F| <= 32 -> (41.052 + 40.044 + 38.04 + 30.04 + 32.04) * v * v / (pair_discriminant_error * (1 + F * v)) in [0, 1] }
# So sigma: 1 / (certainty * pair_discriminant_error) <= 2^88.
{ |F| <= 32 -> certainty * pair_discriminant_error * 1b88 * (1 + F * v) - 1 >= -1b-40 }

# The root: s = sqrt(D.hi) (1 + e), what is left of D in the unit of s^2, and the step by three operations. T is the exact root.
{ |E1| <= 1 -> |(1 / ((1 + e1) * (1 + e1)) - 1) / v| <= 2.0001 }
{ |R| <= 3.001 /\ |F3| <= 3.0001 -> |r * (1 / (1 + T) - (1 + f3) / 2) / (v * v)| <= 5.8 /\ |r * (1 + f3) / 2 / v| <= 1.502 }
# D's error z, in the unit of D.
{ |Z| <= 1 /\ |F| <= 32 -> 1 / (1 + sqrt(1 + Z / certainty)) / ((1 + root_share) / 2 * (1 + F * v)) in [0, 1] }

# q = B + sgn+(B) root: the low parts' sum, and it added to what splitting q leaves. Of |q|, of sqrt(S) and of s.
{ |P| <= 1.0001 /\ |E2| <= 1 -> |p * e2 / (v * v)| <= 1.001 }
{ |X| <= 4.0031 /\ |E1| <= 1 /\ |E2| <= 1 -> |x * (e1 + e2 + e1 * e2) / (v * v)| <= 8.01 /\ |x * (1 + e1) * (1 + e2) / v| <= 4.01 }
{ |X| <= 1.5021 /\ |E1| <= 1 /\ |E2| <= 1 -> |x * (e1 + e2 + e1 * e2) / (v * v)| <= 3.01 /\ |1.0001 + x * (1 + e1) * (1 + e2) / v| <= 2.51 }
# Its low part, as a share of it; and what dividing by high parts costs.
{ |x| <= 1b-6 -> |1 / (1 + x) * (1 / (1 + x))| <= 1.04 }

# divide(n, d): r = n.hi - q d.hi of two roundings, x and y the low parts of n and of d times q: the step of the exact (r + x - y) / (1 + y)
# takes four operations of r (it need not be exact) and of x, five of y. Of d = A, y = 3.002 v: the factors of r, x, y.
{ |E1| <= 1 /\ |E2| <= 1 -> |((1 + e1) * (1 + e2) - 1) / v| <= 2.0001 }
{ |F4| <= 4.0001 /\ |Y| <= 3.0021 -> |(1 + f4 - 1 / (1 + y)) / v| <= 7.003 }
{ |F5| <= 5.0001 /\ |Y| <= 3.0021 -> |(1 + f5 - 1 / (1 + y)) / v| <= 8.003 }
# Of d = q, where y is up to 2^-6: beyond the four or five roundings it is within 1.02 y.
{ |Y| <= 1b47 -> |1 / (1 + y)| <= 1.02 }

# q / A, what is relative to the root: of q (1.001 + 5.8 + 3.01), of A, of divide() with x = 2.51, and the room. Then of rho: of B and q, of
# divide() with x = 4.01, and the room.
{ |F| <= 32 -> (1.001 + 5.8 + 3.01 + 8.01 + 2.0001 * 7.003 + 2.51 * 7.003 + 3.002 * 8.003 + (2.0001 + 2.51 + 3.002)) * 1.04 * v * v
     / (pair_steps * (1 + F * v)) in [0, 1] }
{ |F| <= 32 -> (15.02 + 8.01 + 4.01 * 7.003 + 4.01) * 1.04 * v * v / (pair_steps * (1 + F * v)) in [0, 1] }
# C / q: likewise, with x = 1.0001 and y = 2.51 + 4.01 rho; of rho^2 <= rho sigma beside D's error, halved by the root.
{ |F| <= 32 -> (1.001 + 5.8 + 3.01 + 3.0003 * (4.0001 + 1.02 * 2.51) + 2.51 * (5.0001 + 1.02 * 2.51) + (3.0003 + 2.51)) * 1.04 * v * v
     / (pair_steps * (1 + F * v)) in [0, 1] }
{ |F| <= 32 -> (15.02 + 8.01 + 3.0003 * 1.02 * 4.01 + 4.01 * 5.0001 + 2 * 1.02 * 2.51 * 4.01 + 4.01) * 1.04 * v * v
     / (pair_steps * (1 + F * v)) in [0, 1] }
{ |F| <= 32 -> ((41.052 + 40.044 + 38.04 + 30.04 + 32.04) / 2 * (1 + root_share) + 1.02 * 4.01 * 4.01) * 1.04 * v * v
     / (pair_discriminant_error / 2 * (1 + F * v)) in [0, 1] }

# float: A's 3 and B's 4 roundings, and 2^-40 v of pairs.
{ |F| <= 4.0001 /\ |G| <= 32 -> |(F + 1b-40) * v / (double_steps * (1 + G * v))| <= 1 }
