# The determinants of lanes and what their verdict makes of them, each format by itself (src/batch/triangles-inl.hpp).
#
# A monomial is rounded as triangle_filter.g says: two of its factors are rounded differences, or (`distance`) all three; one product, the
# cross product's difference, the second product, two sums. The magnitudes' sums nd, n1, n2, nt lie in [low, high]; with them a bound is
# computed in 12 roundings. F is of k roundings, H of underflow, flush-to-zero and denormals-are-zero, in units.
#
# Proved, in this order: what underflows in a monomial, with its factors read as zero, is below 2^-28 units of the product of the sums
# (six monomials: 2^-25), and nothing overflows; a determinant's error is at most its bound as computed; w's, and that of distance - t whole,
# at most the bounds' sum by the share, as computed.
#
# Left to say: the monomials' magnitudes add to at most the product of the three sums.
batch_determinant_error = 9b0;   # bound: src/batch/bounds.hpp
batch_combination_share = 5b-2;  # bound: src/batch/bounds.hpp
batch_float_low = 1b-24;         # domain: src/batch/bounds.hpp
batch_float_high = 1b30;         # domain: src/batch/bounds.hpp
batch_double_low = 1b-200;       # domain: src/batch/bounds.hpp
batch_double_high = 1b200;       # domain: src/batch/bounds.hpp
u = 1b-52;                       # and 1b-23

# A factor read as zero; the first product; the second.
{ 3b-126 / (batch_float_low / 2) / 1b-23 in [0, 1b-28] /\ 2b-126 / (batch_float_low * batch_float_low / 4) / 1b-23 in [0, 1b-28]
/\ 1b-126 / (batch_float_low * batch_float_low * batch_float_low / 8) / 1b-23 in [0, 1b-27] }
{ 3b-1022 / (batch_double_low / 2) / 1b-52 in [0, 1b-28] /\ 2b-1022 / (batch_double_low * batch_double_low / 4) / 1b-52 in [0, 1b-28]
/\ 1b-1022 / (batch_double_low * batch_double_low * batch_double_low / 8) / 1b-52 in [0, 1b-28] }
{ batch_float_high * batch_float_high * batch_float_high * batch_float_high * 64 in [0, 1b127]
/\ batch_double_high * batch_double_high * batch_double_high * batch_double_high * 64 in [0, 1b1000] }

# The determinant, u and v; the distance.
{ |F7| <= 114695b-14 /\ |H| <= 1b-24 /\ |F12| <= 196620b-14 -> |(F7 + H) / (batch_determinant_error * (1 + F12 * u))| <= 1 }
{ |F8| <= 131080b-14 /\ |H| <= 1b-24 /\ |F12| <= 196620b-14 -> |(F8 + H) / (batch_determinant_error * (1 + F12 * u))| <= 1 }

# Two roundings more of each of them, against the share of the sum of the bounds, in two roundings more.
{ |F10| <= 163850b-14 /\ |H| <= 1b-23 /\ |F14| <= 229390b-14 ->
   |(F10 + H) / (batch_combination_share * batch_determinant_error * (1 + F14 * u))| <= 1 }
