// Random numbers and vectors for the inputs that are timed: a function of the seed alone, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "graze/types.hpp"

namespace graze::bench {

inline constexpr std::uint64_t default_seed = 20260101;

template <Real T>
class Source {
 public:
  explicit Source(std::uint64_t seed = default_seed) : bits_(seed) {}

  /// In [-1, 1].
  T uniform() { return static_cast<T>(static_cast<double>(bits_()) * 0x1p-63 - 1); }
  /// In [0, 1].
  T fraction() { return static_cast<T>(static_cast<double>(bits_()) * 0x1p-64); }
  /// An integer in [-n, n].
  T integer(std::int64_t n) {
    return static_cast<T>(static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(2 * n + 1)) - n);
  }
  bool coin() { return (bits_() & 1) != 0; }
  std::uint64_t below(std::uint64_t n) { return bits_() % n; }
  Vec3<T> point() {
    const T x = uniform(), y = uniform(), z = uniform();
    return {x, y, z};
  }
  Vec3<T> lattice_point(std::int64_t n) {
    const T x = integer(n), y = integer(n), z = integer(n);
    return {x, y, z};
  }
  /// A power of two with an exponent uniform in [low, high].
  T power(int low, int high) {
    return std::ldexp(T(1), low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1)));
  }

 private:
  std::mt19937_64 bits_;
};

template <Real T>
Vec3<T> combination(const Vec3<T>& p, T s, const Vec3<T>& q, T r, const Vec3<T>& v) {
  return {p.x + s * q.x + r * v.x, p.y + s * q.y + r * v.y, p.z + s * q.z + r * v.z};
}

template <Real T>
Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <Real T>
Vec3<T> scaled(const Vec3<T>& a, T s) {
  return {s * a.x, s * a.y, s * a.z};
}

template <Real T>
Vec3<T> perpendicular(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Of length 1, but for rounding; a zero vector stays.
template <Real T>
Vec3<T> unit(const Vec3<T>& a) {
  const T length = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
  return length == 0 ? a : scaled(a, 1 / length);
}

}  // namespace graze::bench
