# The 64 leading bits of a value (src/numeric/approximation.hpp), in units of the last one. Mantissas are in [2^63, 2^64); a double's steps
# are in any rounding mode, 2^-52 each.
#
# Proved, in this order: a double's quotient of two mantissas cut to 53 bits and its root of one are within 7 * 2^-53 of theirs; so the
# remainders in integers are below 2^79, and the step that a double makes of one is right to 2^-30 before it is cut to an integer, but for
# the square of the root's; so the root, of a mantissa within 1, is within 2.01, a sum within 4.02, and a quotient of one such and a
# mantissa within 1 within slack.
#
# Left to say: products, differences and shifts of integers are exact: 2^127 holds them. The clamp to [2^63, 2^64) moves a result
# toward the value, which lies there.
approximation_slack = 16b0;  # bound: src/numeric/approximation.hpp

# The quotient's guess: two cuts, a rounding. The root's: a cut, a root, a product with a rounded constant.
{ c1 in [-1b-52, 0] /\ c2 in [-1b-52, 0] /\ |e| <= 1b-52 -> |(1 + c1) * (1 + e) / (1 + c2) - 1| <= 7b-53 }
{ c1 in [-1b-52, 0] /\ |f2| <= 32770b-66 /\ |k| <= 1b-53 -> |sqrt(1 + c1) * (1 + f2) * (1 + k) - 1| <= 7b-53 }
# The remainders, q d - base d for base below 2^64, and root^2 - base^2 = (root + base) (root - base).
{ |g| <= 7b-53 -> |g * 1b64 * 1b64| <= 1b79 /\ |g * 1b64 * 1b64 * (2 + g)| <= 1b79 }
# The step: z = rest / 2^16 is cut, converted, multiplied by 2^16 and divided by d cut to 53 bits.
{ |rest| <= 1b79 /\ cut in [-1, 0] /\ d in [1b63, 1b64] /\ c in [-1b-52, 0] /\ |f2| <= 32770b-66 ->
   |cut * 1b16 / d| <= 1b-31 /\ |((1 + f2) / (1 + c) - 1) * 1b15| <= 1b-33 }
# Newton's step leaves g^2 / 2 of the root's error g.
{ |g| <= 7b-53 -> |g * g * 1b64| <= 1b-30 }
# A mantissa m < 2^64 within 1 moves the root of m 2^64 by 2^64 / (2 root), one of m 2^63 by half of it times sqrt(2); the cut is 1.
{ m in [1b63, 1b64] /\ |k| <= 1b-30 -> 1b64 / (2 * sqrt(m * 1b64)) + 1 + k <= 2.01 }
# A sum: what either errs by, or both halves, and two cuts.
{ |a| <= 2.01 /\ |b| <= 2.01 /\ cut1 in [-1, 0] /\ cut2 in [-1, 0] -> |a / 2 + b / 2 + cut1 + cut2| <= 4.02 /\ |a + b / 2 + cut1| <= 4.02 }
# The quotient, below 2^64: its inputs' errors, a cut, the step.
{ |n| <= 4.02 /\ |d| <= 1 /\ cut in [-1, 1] /\ |k| <= 1b-30 ->
   |(((1 + n / 1b63) / (1 + d / 1b63) - 1) * 1b64 + cut + k) / approximation_slack| <= 1 }
{ |n| <= 1 /\ |d| <= 4.02 /\ cut in [-1, 1] /\ |k| <= 1b-30 ->
   |(((1 + n / 1b63) / (1 + d / 1b63) - 1) * 1b64 + cut + k) / approximation_slack| <= 1 }
