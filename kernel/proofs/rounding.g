# One operation in any rounding mode, and the product of up to fourteen of them: what every other script starts from.
#
# Proved: in [1, 2] each of the four roundings errs by at most the unit, that to nearest by half of it; so wherever numbers are normal the
# relative error is at most that, for every binade is this one times a power of two. Below them the error is at most the least
# subnormal number. And (1 + e1) ... (1 + ek) = 1 + f, where |f| <= k (1 + 2^-14) units for k <= 14 and |ei| <= 1 unit.
#
# Left to say: flush-to-zero answers 0 for a result below the normal numbers, denormals-are-zero reads such an input as 0; both err by less
# than 2^-1022, in float 2^-126. Two operations contracted to an fma are rounded once instead of twice. In x87's wider format a result is
# rounded twice, by 2^-64 and then to nearest, less than a unit together; in a directed mode twice in one direction, which is once. So
#   computed = exact (1 + e) + h,   |e| <= 1 unit,   |h| <= 2^-1022 (2^-126).
# The scripts count errors in units u: E u is an error, and what is proven is of E. Where both precisions are used each goal is proven with both.
@nearest = float<ieee_64, ne>;
@upward = float<ieee_64, up>;
@downward = float<ieee_64, dn>;
@toward_zero = float<ieee_64, zr>;
@float_nearest = float<ieee_32, ne>;
@float_upward = float<ieee_32, up>;
@float_downward = float<ieee_32, dn>;
@float_toward_zero = float<ieee_32, zr>;

double_unit = 1b-52;  # bound: graze/numeric/filter.hpp
float_unit = 1b-23;   # bound: graze/numeric/filter.hpp
u = 1b-52;            # and 1b-23

{ x in [1, 2] -> |(nearest(x) - x) / (double_unit / 2)| <= 1 }
{ |x| in [1, 2] -> |(upward(x) - x) / double_unit| <= 1 }
{ |x| in [1, 2] -> |(downward(x) - x) / double_unit| <= 1 }
{ |x| in [1, 2] -> |(toward_zero(x) - x) / double_unit| <= 1 }
{ x in [1, 2] -> |(float_nearest(x) - x) / (float_unit / 2)| <= 1 }
{ |x| in [1, 2] -> |(float_upward(x) - x) / float_unit| <= 1 }
{ |x| in [1, 2] -> |(float_downward(x) - x) / float_unit| <= 1 }
{ |x| in [1, 2] -> |(float_toward_zero(x) - x) / float_unit| <= 1 }
{ |x| <= 1b-1022 ->
  |nearest(x) - x| <= 1b-1074 /\ |upward(x) - x| <= 1b-1074 /\ |downward(x) - x| <= 1b-1074 /\ |toward_zero(x) - x| <= 1b-1074 }
{ |x| <= 1b-126 -> |float_nearest(x) - x| <= 1b-149 /\ |float_upward(x) - x| <= 1b-149
  /\ |float_downward(x) - x| <= 1b-149 /\ |float_toward_zero(x) - x| <= 1b-149 }

# A product of k, and one more.
{ |F| <= 16385b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 32770b-14 }
{ |F| <= 32770b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 49155b-14 }
{ |F| <= 49155b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 65540b-14 }
{ |F| <= 65540b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 81925b-14 }
{ |F| <= 81925b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 98310b-14 }
{ |F| <= 98310b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 114695b-14 }
{ |F| <= 114695b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 131080b-14 }
{ |F| <= 131080b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 147465b-14 }
{ |F| <= 147465b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 163850b-14 }
{ |F| <= 163850b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 180235b-14 }
{ |F| <= 180235b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 196620b-14 }
{ |F| <= 196620b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 213005b-14 }
{ |F| <= 213005b-14 /\ |E| <= 1 -> |F + E + F * E * u| <= 229390b-14 }
