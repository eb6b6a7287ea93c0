// What the numbers of the rounding stage err by at most. It runs in rounding to nearest, where v = 2^-53 is the relative error
// of one operation; in double-double errors are counted in v^2 = 2^-106. Each constant is proven in the script of kernel/proofs
// that is named, and held equal to the one there by a test.
#pragma once

namespace graze::rounding {

// candidate.g
/// What the rounding test adds to an error, as a share of it, for its own steps.
inline constexpr double margin_share = 0x1p-50;
/// What the sum of a candidate's parts costs for float, as a share of it.
inline constexpr double float_sum_error = 0x1p-52;

// face.g
/// A determinant in double-double, as a share of the product that TriangleTerms' bound is triangle_error units of: 63.1 v^2.
inline constexpr double pair_determinant_error = 0x1p-100;
/// A quotient of normalised pairs, and what the rounding test asks of it: 15.3 v^2.
inline constexpr double pair_quotient_error = 0x1p-102;
/// A quotient of doubles, as a share of what it comes out as.
inline constexpr double quotient_error = 0x1p-52;
/// A determinant or a discriminant is good for a quotient or a root where it exceeds its error this many times.
inline constexpr double certainty = 0x1p10;
/// What first order leaves out of a quotient's error, as a share of it.
inline constexpr double second_order = 0x1p-9;

// roots.g
/// The same of a root's error.
inline constexpr double root_share = 0x1p-11;
/// B in double-double, the steps from there to a root, and what the rounding test asks of it, as a share of sqrt(A c_size) and
/// of the root: 83 and 86 v^2.
inline constexpr double pair_steps = 0x1p-99;
/// For float, where A, B, C and D are those of the filter: 4 v.
inline constexpr double double_steps = 0x1p-50;
/// C in double-double, as a share of c_size: 25 v^2.
inline constexpr double pair_c_error = 0x1p-101;
/// D in double-double and second order, as a share of A c_size: 223 v^2.
inline constexpr double pair_discriminant_error = 0x1p-98;

}  // namespace graze::rounding
