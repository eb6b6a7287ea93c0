// Lattice constructions that several families share.
#include "fuzz/families/constructions.hpp"

namespace graze::fuzz::construct {

Frame choose_frame(Random& random, int quaternion_bits) {
  const IntVec v = choose_vector(random, quaternion_bits);
  const Int w = choose_integer(random, quaternion_bits);
  const Int ww = w * w, xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
  Frame frame;
  frame.r1 = {ww + xx - yy - zz, 2 * (v.x * v.y + w * v.z), 2 * (v.x * v.z - w * v.y)};
  frame.r2 = {2 * (v.x * v.y - w * v.z), ww - xx + yy - zz, 2 * (v.y * v.z + w * v.x)};
  frame.r3 = {2 * (v.x * v.z + w * v.y), 2 * (v.y * v.z - w * v.x), ww - xx - yy + zz};
  frame.length = ww + xx + yy + zz;
  Int common = frame.length;
  for (const IntVec* column : {&frame.r1, &frame.r2, &frame.r3}) {
    for (int axis = 0; axis < 3; ++axis) common = gcd((*column)[axis], common);
  }
  if (common == 1) return frame;
  frame.r1 = frame.r1 / common;
  frame.r2 = frame.r2 / common;
  frame.r3 = frame.r3 / common;
  frame.length /= common;
  return frame;
}

IntVec choose_orthogonal(Random& random, const IntVec& w, int bits) {
  const IntVec v = choose_vector(random, bits);
  IntVec d = cross(w, v);
  if (is_zero(d)) d = w.x != 0 || w.y != 0 ? IntVec{-w.y, w.x, 0} : IntVec{1, 0, 0};
  return primitive(d);
}

IntVec bezout_vector(const IntVec& w) {
  const Bezout first = bezout(w.x, w.y);
  const Bezout both = bezout(first.gcd, w.z);
  // first.gcd * s + w.z * t = 1, with s reduced modulo w.z to keep the numbers small.
  Int s = both.x, t = both.y;
  if (w.z != 0 && first.gcd != 0) {
    s = residue(both.x, w.z);
    t = (1 - first.gcd * s) / w.z;
  }
  return {s * first.x, s * first.y, t};
}

Barycentric choose_point(Random& random, int most_bits) {
  Barycentric at;
  switch (random.below(8)) {
    case 0:
      at.q = 1;
      break;
    case 1:
    case 2:
    case 3:
    case 4: {
      const int exponent = random.between(0, most_bits - 1);
      at.q = power_of_two(exponent);
      break;
    }
    case 5: {
      const int exponent = random.between(0, most_bits - 2);
      at.q = 3 * power_of_two(exponent);
      break;
    }
    default: {
      const int length = choose_bits(random, 1, most_bits);
      at.q = choose_full(random, length) | 1;
      break;
    }
  }
  const auto choose_part = [&](Int whole) { return residue(choose_natural(random, 64), whole); };
  const Int part = at.q > 1 ? 1 + choose_part(at.q - 1) : 0;  // strictly between 0 and q where there is room
  const std::uint64_t off_roll = random.below(8);
  const Int off = off_roll == 0 ? -1 : off_roll == 1 ? 1 : 0;  // one step outside, one step inside
  switch (random.below(9)) {
    case 0: {
      const std::uint64_t corner = random.below(3);
      at.i = corner == 1 ? at.q : 0;
      at.j = corner == 2 ? at.q : 0;
      break;
    }
    case 1:
    case 2:
      at.i = part;
      at.j = off;
      break;
    case 3:
    case 4:
      at.i = off;
      at.j = part;
      break;
    case 5:
    case 6:
      at.i = part;
      at.j = at.q - part - off;
      break;
    default:
      at.i = part;
      if (at.q - part > 1) at.j = 1 + choose_part(at.q - part - 1);
      break;
  }
  return at;
}

TriangleKind kind_at(const Barycentric& point) {
  const Int k = point.q - point.i - point.j;
  if (point.i < 0 || point.j < 0 || k < 0) return TriangleKind::miss;
  if (point.i == point.q) return TriangleKind::vertex_b;
  if (point.j == point.q) return TriangleKind::vertex_c;
  if (k == point.q) return TriangleKind::vertex_a;
  if (point.j == 0) return TriangleKind::edge_ab;
  if (k == 0) return TriangleKind::edge_bc;
  if (point.i == 0) return TriangleKind::edge_ca;
  return TriangleKind::face;
}

Quotient near_midpoint(Random& random, int bits, int digits) {
  const Int den = choose_full(random, bits) | 1;
  UnsignedInt inverse = 1;  // of den modulo 2^128, by Newton's iteration
  for (int step = 0; step < 7; ++step) inverse *= 2 - static_cast<UnsignedInt>(den) * inverse;
  const Int modulus = power_of_two(digits + 1);
  const Int midpoint = static_cast<Int>(inverse & static_cast<UnsignedInt>(modulus - 1));
  if (2 * midpoint >= modulus) return {(midpoint * den - 1) / modulus, den};
  return {((modulus - midpoint) * den + 1) / modulus, den};
}

TriangleDraft aimed_triangle(const Aim& aim) {
  TriangleDraft draft;
  const IntVec target = aim.point.i * aim.e1 + aim.point.j * aim.e2;
  draft.corner = {IntVec{}, aim.point.q * aim.e1, aim.point.q * aim.e2};
  draft.origin = target - aim.tau * aim.d;
  draft.direction = aim.alpha * aim.d;
  if (surely_independent(aim.d, aim.e1, aim.e2)) {
    draft.promise = {kind_at(aim.point), one_mark(make_mark(aim.tau, aim.alpha))};
  }
  return draft;
}

}  // namespace graze::fuzz::construct
