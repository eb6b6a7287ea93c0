# t, u and v of a face (src/rounding/face.cpp), in rounding to nearest: v = 2^-53, E its roundings in that unit.
#
# For double: monomials of the determinants are taken through the operations on pairs of src/numeric/double_double.hpp, whose splits are
# without error (Knuth 1969, Dekker 1971). The exact monomial is 1; P is the low part that splitting its high part leaves, X and Y the low
# parts that come in, in units of v. The longest way is that of `distance`, e2 . (t x e1). Each step's error is in units of v^2, and its own
# low part is what comes into the next.
#
# Proved, step by step: the determinants err by 63.047 v^2 of their monomials' magnitudes, less than pair_determinant_error of the product
# that TriangleTerms' bound is made of, |d| s r or s s r (triangle_filter.g), which it computes in 14 roundings of 2^-52; a quotient of pairs errs by 12.01 v^2, and with the
# rounding test's room that is within pair_quotient_error; a quotient of doubles errs by quotient_error; where the determinant is known to
# 1 / certainty, the terms' errors enter a quotient to first order and (1 + second_order) of that, as computed in at most 7 roundings.
#
# Left to say: for the determinant that is used d and the true one D, |N / D - n / d| <= (|N - n| + |n / d| |D - d|) / |D|, and |D| >=
# |d| (1 - 1 / certainty). What underflows in vectors of these sizes is below 2^-100 of v^2 (triangle_filter.g).
pair_determinant_error = 1b-100;     # bound: src/rounding/error_bounds.hpp
pair_quotient_error = 1b-102;        # bound: src/rounding/error_bounds.hpp
quotient_error = 1b-52;              # bound: src/rounding/error_bounds.hpp
certainty = 1b10;                    # bound: src/rounding/error_bounds.hpp
second_order = 1b-9;                 # bound: src/rounding/error_bounds.hpp

v = 1b-53;
p = P * v; x = X * v; y = Y * v; r = R * v;
e1 = E1 * v; e2 = E2 * v; e3 = E3 * v; e4 = E4 * v; f2 = F2 * v;

# A product of pairs t e1: p + (x + y), three roundings of x and y, and x y is left out.
{ |P| <= 1.0001 /\ |X| <= 1.0001 /\ |Y| <= 1.0001 /\ |E1| <= 1 /\ |F2| <= 2.0001 ->
   |(p * e1 + (x + y) * (f2 + e1 + f2 * e1) - x * y) / (v * v)| <= 8.01 /\ |((p + (x + y) * (1 + f2)) * (1 + e1)) / v| <= 3.001 }
# A component of t x e1, the difference of two.
{ |P| <= 1.0001 /\ |X| <= 3.0011 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 7.003 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 4.002 }
# e2 times it.
{ |P| <= 1.0001 /\ |X| <= 1.0001 /\ |Y| <= 4.0021 /\ |E1| <= 1 /\ |F2| <= 2.0001 ->
   |(p * e1 + (x + y) * (f2 + e1 + f2 * e1) - x * y) / (v * v)| <= 20.018 /\ |((p + (x + y) * (1 + f2)) * (1 + e1)) / v| <= 6.003 }
# Two of these added.
{ |P| <= 1.0001 /\ |X| <= 6.0031 /\ |E1| <= 1 /\ |E2| <= 1 ->
   |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 13.007 /\ |((p + x * (1 + e1)) * (1 + e2)) / v| <= 7.004 }
# Two such sums added.
{ |P| <= 1.0001 /\ |X| <= 7.0041 /\ |E1| <= 1 /\ |E2| <= 1 -> |(p * e2 + x * (e1 + e2 + e1 * e2)) / (v * v)| <= 15.009 }
# The sum of these.
{ |f14| <= 229390b-66 -> (8.01 + 7.003 + 20.018 + 13.007 + 15.009) * v * v / (pair_determinant_error * (1 + f14)) in [0, 1] }

# The quotient of normalised pairs n / d, in the unit of the quotient q of their high parts. r = n.hi - q d.hi is exact, x and y are n.lo and
# q d.lo; the step, of the exact (r + x - y) / (1 + y) by four operations.
{ |R| <= 1.0001 /\ |X| <= 1.0001 /\ |Y| <= 1.0001 /\ |E1| <= 1 /\ |E2| <= 1 /\ |E3| <= 1 /\ |E4| <= 1 ->
   |(r * ((1 + e3) * (1 + e4) - 1 / (1 + y)) + x * ((1 + e2) * (1 + e3) * (1 + e4) - 1 / (1 + y))
     - y * ((1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1 / (1 + y))) / (v * v)| <= 12.01
/\ |(r + (x - y * (1 + e1)) * (1 + e2)) * (1 + e3) * (1 + e4) / v| <= 3.2 }
# With the room of candidate.g; the bound is added up in 2 roundings.
{ |F2| <= 2.0001 -> (12.01 * v * v + 13b-108) / (pair_quotient_error * (1 + f2)) in [0, 1] }
# float: one rounding of a quotient that is known through q.
{ |E1| <= 1 /\ |E2| <= 1 /\ |E3| <= 1 -> e1 / (1 + e1) / (quotient_error * (1 + e2) * (1 + e3)) in [-1, 1] }

{ |f7| <= 114695b-66 /\ |q| <= 4b-53 -> (1 + q) / (1 - 1 / certainty) / ((1 + second_order) * (1 + f7)) in [0, 1] }
