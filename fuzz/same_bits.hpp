// Bitwise equality of answers: every field, meaningful or not; +0 differs from -0, and a NaN equals itself alone.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "fuzz/case.hpp"

namespace graze::fuzz {

template <Real T>
[[nodiscard]] constexpr bool same_bits(T a, T b) {
  using Bits = std::conditional_t<std::same_as<T, float>, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <Real T>
[[nodiscard]] constexpr bool same_bits(const SphereHit<T>& a, const SphereHit<T>& b) {
  return a.status == b.status && a.kind == b.kind && a.root == b.root && a.origin == b.origin && same_bits(a.t[0], b.t[0]) &&
         same_bits(a.t[1], b.t[1]);
}

template <Real T>
[[nodiscard]] constexpr bool same_bits(const TriangleHit<T>& a, const TriangleHit<T>& b) {
  return a.status == b.status && a.kind == b.kind && a.facing == b.facing && same_bits(a.t, b.t) &&
         same_bits(a.t_end, b.t_end) && same_bits(a.u, b.u) && same_bits(a.v, b.v);
}

[[nodiscard]] constexpr bool same_bits(const Side& a, const Side& b) {
  return a == b;
}

/// Answers of unlike queries differ.
template <Real T>
[[nodiscard]] constexpr bool same_bits(const Answer<T>& a, const Answer<T>& b) {
  return std::visit(
      []<class A, class B>(const A& x, const B& y) {
        if constexpr (std::same_as<A, B>) {
          return same_bits(x, y);
        } else {
          return false;
        }
      },
      a, b);
}

}  // namespace graze::fuzz
