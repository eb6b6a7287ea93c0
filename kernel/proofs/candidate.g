# The rounding test (src/rounding/candidate.hpp), which runs in rounding to nearest.
#
# A value lies within `error`, less room, of hi + lo. `below` is rounded from hi + (lo - margin), `above` from hi + (lo + margin), margin =
# error (1 + margin_share) + slack. For double the sum hi + x is the rounding that is asked for, of the very number hi + x; for float
# it is rounded to double first, and slack pays for that.
#
# Proved: (lo - margin) as computed is at most lo - error + room, where room = 13/4 * 2^-106 |hi| pays for a low part of 3.2 * 2^-53 |hi|;
# for float also where the sum's own rounding is taken off it.
#
# Left to say: so hi + (lo - margin) as computed is below the value, and hi + (lo + margin) above it. Rounding is monotone: if both round
# to one number, so does the value. The sizes that are asked for keep both away from subnormal numbers and from overflow.
margin_share = 1b-50;       # bound: src/rounding/error_bounds.hpp
float_sum_error = 1b-52;    # bound: src/rounding/error_bounds.hpp

v = 1b-53;
e1 = E1 * v; e2 = E2 * v; e3 = E3 * v;

# What is taken of an error, in the unit of it: the product, for float a sum, lo - margin and at last the sum with hi.
{ |E1| <= 1 /\ |E2| <= 1 /\ |E3| <= 1 -> (1 + margin_share) * (1 + e1) * (1 + e2) * (1 + e3) - v >= 1 }

# What the last sum costs for float, in the unit of |hi|: the number is hi + lo, up to what margin_share has paid for.
{ |E2| <= 1 /\ |E3| <= 1 /\ |L| <= 64 -> (1 + L * v) * v / (float_sum_error * (1 + e2) * (1 + e3)) in [0, 1] }

{ |L| <= 3.2 -> |L * v * v| <= 13b-108 }
