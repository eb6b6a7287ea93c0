// A ray in the triangle's plane: the line is clipped against the three edges, seen along an axis that the normal has.
#include "oracle/gmp_triangle.hpp"

namespace graze::oracle::gmp {
namespace {

/// The interval of the line that survives; an end is open until an edge sets it.
struct Clipper {
  CommonPart& part;
  bool has_lower = false, has_upper = false, empty = false;

  /// Keeps the t with level + t * slope >= 0.
  void keep(const mpz_class& level, const mpz_class& slope) {
    if (sgn(slope) == 0) {
      if (sgn(level) < 0) empty = true;
      return;
    }
    thread_local Fraction bound;
    bound.num = -level;
    bound.den = slope;
    make_denominator_positive(bound);
    const bool rising = sgn(slope) > 0;
    Fraction& end = rising ? part.t : part.t_end;
    bool& has_end = rising ? has_lower : has_upper;
    if (!has_end || compare(bound, end) * (rising ? 1 : -1) > 0) end = bound;
    has_end = true;
  }
};

}  // namespace

void intersect_parallel(CommonPart& out, const IntegerTriangle& triangle, const Vector& normal, const Range& range) {
  thread_local Vector from_a, edge, offset;
  thread_local mpz_class height, level, slope;
  out.kind = TriangleKind::miss;
  subtract(from_a, triangle.origin, triangle.a);
  dot(height, from_a, normal);
  if (sgn(height) != 0) return;

  const std::size_t axis = nonzero_axis(normal);
  Clipper clipper{out};
  const Vector* const corners[] = {&triangle.a, &triangle.b, &triangle.c, &triangle.a};
  for (int i = 0; i < 3; ++i) {
    // Left of the edge counterclockwise: the normal's component of edge x (point - corner) has the normal's own sign.
    subtract(edge, *corners[i + 1], *corners[i]);
    subtract(offset, triangle.origin, *corners[i]);
    cross(level, edge, offset, axis);
    cross(slope, edge, triangle.direction, axis);
    if (sgn(normal[axis]) < 0) {
      level = -level;
      slope = -slope;
    }
    clipper.keep(level, slope);
  }
  // A line in the plane is parallel to at most one edge, so a triangle with area bounds it at both ends.
  if (!clipper.empty && clip(out, range, triangle.exponent)) out.kind = TriangleKind::coplanar;
}

}  // namespace graze::oracle::gmp
