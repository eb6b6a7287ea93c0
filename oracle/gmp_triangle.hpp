// Ray and triangle in integers, and the parts of the question: the crossing, the coplanar and the degenerate case.
#pragma once

#include "graze/answer.hpp"
#include "oracle/gmp_range.hpp"
#include "oracle/gmp_vector.hpp"

namespace graze::oracle::gmp {

/// With positions in units of 2^p and the direction in units of 2^q, t is an integer ratio times 2^exponent, exponent = p - q.
struct IntegerTriangle {
  Vector origin, direction, a, b, c;
  Vector edge_b, edge_c;  ///< b - a and c - a
  Vector d_cross_edge_c;  ///< direction x (c - a)
  mpz_class determinant;  ///< (b - a) . (d x (c - a)) = -(d . n)
  int exponent = 0;
};

/// The common part, unrounded. t and t_end are to be multiplied by 2^exponent.
struct CommonPart {
  TriangleKind kind = TriangleKind::miss;
  Fraction t, t_end, u, v;
};

/// The ray's line crosses the triangle's plane in one point: the determinant is not zero.
void intersect_crossing(CommonPart& out, const IntegerTriangle& triangle, const Range& range);

/// The determinant is zero and the normal is not.
void intersect_parallel(CommonPart& out, const IntegerTriangle& triangle, const Vector& normal, const Range& range);

/// The three corners lie on one line.
void intersect_degenerate(CommonPart& out, const IntegerTriangle& triangle, const Range& range);

/// Cuts t .. t_end down to the range and says whether anything is left.
[[nodiscard]] bool clip(CommonPart& out, const Range& range, int exponent);

}  // namespace graze::oracle::gmp
