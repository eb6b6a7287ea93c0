// Exact integers and integer vectors: what the lattices are built from. 128 bits, so that products of coordinates do not wrap.
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

namespace graze::fuzz::construct {

__extension__ typedef __int128 Int;
__extension__ typedef unsigned __int128 UnsignedInt;

struct IntVec {
  Int x = 0, y = 0, z = 0;

  constexpr Int& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr const Int& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  bool operator==(const IntVec&) const = default;
};

constexpr IntVec operator+(const IntVec& p, const IntVec& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
constexpr IntVec operator-(const IntVec& p, const IntVec& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
constexpr IntVec operator-(const IntVec& p) {
  return {-p.x, -p.y, -p.z};
}
constexpr IntVec operator*(Int s, const IntVec& p) {
  return {s * p.x, s * p.y, s * p.z};
}
constexpr IntVec operator/(const IntVec& p, Int s) {
  return {p.x / s, p.y / s, p.z / s};
}

constexpr Int dot(const IntVec& p, const IntVec& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
constexpr IntVec cross(const IntVec& p, const IntVec& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
constexpr bool is_zero(const IntVec& p) {
  return p.x == 0 && p.y == 0 && p.z == 0;
}

constexpr Int magnitude(Int n) {
  return n < 0 ? -n : n;
}
constexpr int sign_of(Int n) {
  return (n > 0) - (n < 0);
}
constexpr Int power_of_two(int exponent) {
  return static_cast<Int>(1) << exponent;
}

/// The number of binary digits of |n|; 0 for 0.
constexpr int bit_length(Int n) {
  const auto whole = static_cast<UnsignedInt>(magnitude(n));
  const auto high = static_cast<std::uint64_t>(whole >> 64);
  const auto low = static_cast<std::uint64_t>(whole);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high) : std::bit_width(low));
}

/// The most digits of any coordinate.
constexpr int bit_length(const IntVec& p) {
  int most = bit_length(p.x);
  if (const int length = bit_length(p.y); length > most) most = length;
  if (const int length = bit_length(p.z); length > most) most = length;
  return most;
}

/// Whether n fits in 64 bits with room for a sign and a factor of two: divisions are several times faster there.
constexpr bool is_short(Int n) {
  return bit_length(n) <= 62;
}

constexpr Int gcd(Int a, Int b) {
  while (b != 0 && !(is_short(a) && is_short(b))) a = std::exchange(b, a % b);
  auto short_a = static_cast<std::int64_t>(a);
  auto short_b = static_cast<std::int64_t>(b);
  if (b == 0) return magnitude(a);
  while (short_b != 0) short_a = std::exchange(short_b, short_a % short_b);
  return magnitude(short_a);
}
constexpr Int content(const IntVec& p) {
  return gcd(gcd(p.x, p.y), p.z);
}

/// p without its common factor; zero stays zero.
constexpr IntVec primitive(const IntVec& p) {
  const Int common = content(p);
  return common == 0 ? p : p / common;
}

struct Bezout {
  Int gcd, x, y;  ///< a x + b y = gcd
};
constexpr Bezout bezout(Int a, Int b) {
  Int x0 = 1, y0 = 0, x1 = 0, y1 = 1;
  while (b != 0) {
    const bool is_fast = is_short(a) && is_short(b);
    const Int quotient = is_fast ? static_cast<std::int64_t>(a) / static_cast<std::int64_t>(b) : a / b;
    a = std::exchange(b, a - quotient * b);
    x0 = std::exchange(x1, x0 - quotient * x1);
    y0 = std::exchange(y1, y0 - quotient * y1);
  }
  return a < 0 ? Bezout{-a, -x0, -y0} : Bezout{a, x0, y0};
}

/// The least residue of n modulo |m|, between 0 and |m| - 1.
constexpr Int residue(Int n, Int m) {
  const Int rest = n % magnitude(m);
  return rest < 0 ? rest + magnitude(m) : rest;
}

/// The integer nearest to n / d (either one at a tie); d > 0.
constexpr Int nearest_quotient(Int n, Int d) {
  const Int doubled = 2 * residue(n, d);
  return (n - residue(n, d)) / d + (doubled >= d ? 1 : 0);
}

/// The largest s with s * s <= n; n >= 0.
constexpr Int integer_sqrt(Int n) {
  Int root = 0;
  for (int bit = (bit_length(n) + 1) / 2; bit >= 0; --bit) {
    const Int trial = root + power_of_two(bit);
    if (trial * trial <= n) root = trial;
  }
  return root;
}

/// True only where the determinant of the rows is not zero: it is computed modulo 2^128, so a multiple of 2^128 passes for
/// zero.
constexpr bool surely_independent(const IntVec& p, const IntVec& q, const IntVec& r) {
  const auto term = [](Int a, Int b, Int c) {
    return static_cast<UnsignedInt>(a) * static_cast<UnsignedInt>(b) * static_cast<UnsignedInt>(c);
  };
  const UnsignedInt plus = term(p.x, q.y, r.z) + term(p.y, q.z, r.x) + term(p.z, q.x, r.y);
  const UnsignedInt minus = term(p.z, q.y, r.x) + term(p.y, q.x, r.z) + term(p.x, q.z, r.y);
  return plus != minus;
}

}  // namespace graze::fuzz::construct
