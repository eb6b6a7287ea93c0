// The vector arithmetic of the textbook formulas, every operation rounded in T, left to right. A compiler that contracts
// a * b + c to a fused operation changes the numbers: -ffp-contract=off gives those that are meant.
#pragma once

#include "graze/types.hpp"

namespace graze::textbook {

template <Real T>
[[nodiscard]] constexpr Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <Real T>
[[nodiscard]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <Real T>
[[nodiscard]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace graze::textbook
