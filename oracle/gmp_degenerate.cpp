// A triangle without area: the hull of three corners on a line, which is a segment or a point.
#include <algorithm>
#include <utility>

#include "oracle/gmp_triangle.hpp"

namespace graze::oracle::gmp {
namespace {

/// The least and the greatest corner in lexicographic order: the ends of the hull.
[[nodiscard]] std::pair<const Vector*, const Vector*> hull_ends(const IntegerTriangle& triangle) {
  const Vector* corners[] = {&triangle.a, &triangle.b, &triangle.c};
  std::sort(std::begin(corners), std::end(corners), [](const Vector* p, const Vector* q) { return *p < *q; });
  return {corners[0], corners[2]};
}

/// out = the t with e + t d = e + offset, where offset is parallel to d.
void set_parameter(Fraction& out, const Vector& offset, const Vector& direction) {
  const std::size_t axis = nonzero_axis(direction);
  out.num = offset[axis];
  out.den = direction[axis];
  make_denominator_positive(out);
}

/// The segment lies on the ray's line, or is a point of it.
void meet_along(CommonPart& out, const Vector& to_first, const Vector& to_last, const Vector& direction) {
  set_parameter(out.t, to_first, direction);
  set_parameter(out.t_end, to_last, direction);
  if (compare(out.t, out.t_end) > 0) std::swap(out.t, out.t_end);
  out.kind = TriangleKind::degenerate;
}

/// The segment has a direction of its own: e + t d = first + s (last - first) has at most one solution.
void meet_across(CommonPart& out, const Vector& to_first, const Vector& along, const Vector& direction, const Vector& normal) {
  thread_local mpz_class height;
  dot(height, to_first, normal);
  if (sgn(height) != 0) return;
  thread_local Vector t_num, s_num;
  thread_local Fraction s;
  const std::size_t axis = nonzero_axis(normal);
  cross(t_num, to_first, along);
  cross(s_num, to_first, direction);
  out.t.num = t_num[axis];
  out.t.den = normal[axis];
  make_denominator_positive(out.t);
  s.num = s_num[axis];
  s.den = normal[axis];
  make_denominator_positive(s);
  if (sgn(s.num) < 0 || s.num > s.den) return;
  out.t_end = out.t;
  out.kind = TriangleKind::degenerate;
}

}  // namespace

void intersect_degenerate(CommonPart& out, const IntegerTriangle& triangle, const Range& range) {
  thread_local Vector to_first, to_last, along, normal, moment;
  out.kind = TriangleKind::miss;
  const auto [first, last] = hull_ends(triangle);
  subtract(to_first, *first, triangle.origin);
  subtract(to_last, *last, triangle.origin);
  subtract(along, *last, *first);
  cross(normal, triangle.direction, along);
  if (is_zero(normal)) {
    cross(moment, triangle.direction, to_first);
    if (is_zero(moment)) meet_along(out, to_first, to_last, triangle.direction);
  } else {
    meet_across(out, to_first, along, triangle.direction, normal);
  }
  if (out.kind == TriangleKind::degenerate && !clip(out, range, triangle.exponent)) out.kind = TriangleKind::miss;
}

}  // namespace graze::oracle::gmp
