# The corners' weights and the distance by the sheared ray, each format by itself (src/batch/sheared_triangles-inl.hpp).
#
# With the sheared corners A'x = Ax - s Az, |s| <= 1, and q, z, Q, Z as there. E and F are of roundings, F of k of them, in units.
#
# Proved, in this order: A'x as computed errs by at most 2.001 |A'x| + 4.001 |Az| units (the differences, the slope, the product, the sum; Ax is
# A'x + s Az); a product of two of them, in 2 roundings more, by 6.01 of itself, 4.01 of each |C'x||Bz|, and 2^-16 of |Bz||Cz|; with |C'x B'y| +
# |C'y B'x| <= (qB + qC) / 2 and (|C'x| + |C'y|) |Bz| <= 0.7072 (qC + Bz^2) a weight by 5.9 (qB + qC) + 2.9 (Bz^2 + Cz^2); all weights' sum, in which
# every q is twice, by 14 Q; the distance by 8 Q Z, and less X times the sum by 9 Q (Z + 2 |X|); those are within the bounds as computed. And what
# underflows: 60 f (1 + Q) in a weight, 4 f Q and 346 f (1 + Q) sqrt(z) in the distance, is below 2^-9 units of the bounds, as Q >= z >= least_z.
#
# Left to say: 2 a b <= a^2 + b^2, so a weight is at most (qB + qC) / 2 and Z^2 at most 3 z.
batch_sheared_error = 16b0;  # bound: src/batch/bounds.hpp
u = 1b-52;                   # and 1b-23

# A coordinate: the final rounding E5, the differences' E1, three of the product.
{ |E1| <= 1 /\ |E5| <= 1 -> |E1 + E5 + E1 * E5 * u| <= 32786b-14 }
{ |E1| <= 1 /\ |E5| <= 1 /\ |F3| <= 49155b-14 -> |(E1 - F3) * (1 + E5 * u)| <= 65552b-14 }
# A product of two.
{ |D1| <= 32786b-14 /\ |D2| <= 32786b-14 /\ |F2| <= 32770b-14 ->
   |D1 + D2 + D1 * D2 * u + F2 * (1 + D1 * u) * (1 + D2 * u)| <= 98468b-14 }
{ |D1| <= 32786b-14 /\ |D2| <= 65552b-14 /\ |F2| <= 32770b-14 -> |(1 + D1 * u) * D2 * (1 + F2 * u)| <= 65700b-14 }
{ |D1| <= 65552b-14 /\ |D2| <= 65552b-14 /\ |F2| <= 32770b-14 -> |D1 * D2 * u * (1 + F2 * u)| <= 1b-16 }
# A weight, the sum of all with its two roundings, the distance with four, and that less X times the sum.
{ 98468b-14 / 2 + 0.7072 * 65700b-14 in [0, 5.9] /\ 0.7072 * 65700b-14 + 1b-16 in [0, 2.9] }
{ |F2| <= 32770b-14 -> 2 * 5.9 + F2 * (1 + 5.9 * u) in [0, 14] }
{ |F4| <= 65540b-14 -> 5.9 + F4 * (1b-1 + 5.9 * u) in [0, 8] }
{ |F2| <= 32770b-14 /\ |E| <= 1 -> 8 + E * (1b-1 + 8 * u) in [0, 9] /\ 14 + F2 * (1 + 14 * u) + E * (1 + 17 * u) in [0, 18] }
# The bounds, squared for the distance: E^2 z and E^2 (2 z + 3 X^2).
{ |F8| <= 131080b-14 -> 6 / (batch_sheared_error * (1 + F8 * u)) in [0, 1] }
{ |F14| <= 229390b-14 -> 9.01 * 9.01 * 3 / (batch_sheared_error * batch_sheared_error * (1 + F14 * u)) in [0, 1]
/\ 9.01 * 9.01 * 2 * 3 / (2 * batch_sheared_error * batch_sheared_error * (1 + F14 * u)) in [0, 1]
/\ 9.01 * 9.01 * 2 * 4 / (3 * batch_sheared_error * batch_sheared_error * (1 + F14 * u)) in [0, 1] }
# Underflow, in float and in double: y = 1 / Q, of the bound's share per Q; sqrt(z) is at least 2^-44, 2^-450.
{ y in [0, 1b87] -> 60 * 1b-126 * (1 + y) / 1b-23 in [0, 1b-9] /\ 346 * 1b-126 * (1 + y) / 1b-23 in [0, 1b-6] /\ 4 * 1b-126 * 1b44 / 1b-23 in [0, 1b-9] }
{ y in [0, 1b900] -> 60 * 1b-1022 * (1 + y) / 1b-52 in [0, 1b-9] /\ 346 * 1b-1022 * (1 + y) / 1b-52 in [0, 1b-9] /\ 4 * 1b-1022 * 1b450 / 1b-52 in [0, 1b-9] }
