// Lattice constructions that several families share.
#pragma once

#include "fuzz/families/choose.hpp"
#include "fuzz/families/draft.hpp"

namespace graze::fuzz::construct {

/// Three orthogonal integer vectors of one integer length, right-handed.
struct Frame {
  IntVec r1, r2, r3;
  Int length = 1;
};

/// The rotation matrix of a random integer quaternion of so many bits, times its norm, without common factor.
/// The length has at most 2 * bits + 2 digits, and no coordinate exceeds it.
[[nodiscard]] Frame choose_frame(Random& random, int quaternion_bits);

/// A primitive vector orthogonal to w (w not zero), from a random one of so many bits; at most bits + bit_length(w) + 1 digits.
[[nodiscard]] IntVec choose_orthogonal(Random& random, const IntVec& w, int bits);

/// An integer vector v with v . w = 1, for a primitive w.
[[nodiscard]] IntVec bezout_vector(const IntVec& w);

/// The point (i / q, j / q) in the barycentric coordinates u, v of a triangle.
struct Barycentric {
  Int i = 0, j = 0, q = 1;
};

/// On a corner, on an edge, inside, or one lattice step beside an edge. q has at most so many bits: powers of two, multiples
/// of three, and any odd number.
[[nodiscard]] Barycentric choose_point(Random& random, int most_bits);

/// The kind of a hit there.
[[nodiscard]] TriangleKind kind_at(const Barycentric& point);

struct Quotient {
  Int num, den;  ///< 0 < num <= den
};

/// A quotient in [1/2, 1) with a denominator of so many bits that misses a midpoint of the format by 2^-(digits + 1) / den: the
/// nearest that there is.
[[nodiscard]] Quotient near_midpoint(Random& random, int bits, int digits);

/// A corner at 0, edges q * e1 and q * e2, and a ray that passes the point at t = tau / alpha, in direction alpha * d.
struct Aim {
  IntVec e1, e2;
  Barycentric point;
  IntVec d;
  Int tau = 1, alpha = 1;
};
[[nodiscard]] TriangleDraft aimed_triangle(const Aim& aim);

}  // namespace graze::fuzz::construct
