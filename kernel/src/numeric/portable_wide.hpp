// 128-bit integers for compilers that have none: 32-bit targets. Only what the exact stage asks of them, with the operators of
// __int128, modulo 2^128.
#pragma once

#include <compare>
#include <cstdint>

namespace graze::numeric {

/// high 2^64 + low.
struct PortableWide {
  std::uint64_t low = 0, high = 0;

  constexpr PortableWide() noexcept = default;
  constexpr PortableWide(std::uint64_t low_part, std::uint64_t high_part = 0) noexcept : low(low_part), high(high_part) {}

  [[nodiscard]] constexpr explicit operator std::uint64_t() const noexcept { return low; }
  [[nodiscard]] constexpr explicit operator unsigned char() const noexcept { return static_cast<unsigned char>(low); }

  [[nodiscard]] friend constexpr PortableWide operator+(PortableWide a, PortableWide b) noexcept {
    const std::uint64_t sum = a.low + b.low;
    return {sum, a.high + b.high + (sum < a.low ? 1 : 0)};
  }
  [[nodiscard]] friend constexpr PortableWide operator-(PortableWide a, PortableWide b) noexcept {
    return {a.low - b.low, a.high - b.high - (a.low < b.low ? 1 : 0)};
  }
  [[nodiscard]] friend constexpr PortableWide operator*(PortableWide a, PortableWide b) noexcept {
    // By halves of 32 bits; the middle products and a carry fit 64 bits.
    const std::uint64_t half = 0xffffffff, a0 = a.low & half, a1 = a.low >> 32, b0 = b.low & half, b1 = b.low >> 32;
    const std::uint64_t bottom = a0 * b0, middle = a1 * b0 + (bottom >> 32), other = a0 * b1 + (middle & half);
    return {(other << 32) | (bottom & half), a1 * b1 + (middle >> 32) + (other >> 32) + a.low * b.high + a.high * b.low};
  }
  [[nodiscard]] friend constexpr PortableWide operator&(PortableWide a, PortableWide b) noexcept {
    return {a.low & b.low, a.high & b.high};
  }
  /// 0 <= shift < 128, here and below.
  [[nodiscard]] friend constexpr PortableWide operator<<(PortableWide a, int shift) noexcept {
    if (shift == 0) return a;
    if (shift >= 64) return {0, a.low << (shift - 64)};
    return {a.low << shift, (a.high << shift) | (a.low >> (64 - shift))};
  }
  [[nodiscard]] friend constexpr PortableWide operator>>(PortableWide a, int shift) noexcept {
    if (shift == 0) return a;
    if (shift >= 64) return {a.high >> (shift - 64), 0};
    return {(a.low >> shift) | (a.high << (64 - shift)), a.high >> shift};
  }
  [[nodiscard]] friend constexpr bool operator==(PortableWide a, PortableWide b) noexcept = default;
  [[nodiscard]] friend constexpr std::strong_ordering operator<=>(PortableWide a, PortableWide b) noexcept {
    return a.high != b.high ? a.high <=> b.high : a.low <=> b.low;
  }
};

/// The same bits in two's complement.
struct PortableSignedWide {
  PortableWide bits;

  constexpr PortableSignedWide(std::uint64_t value) noexcept : bits(value) {}
  constexpr PortableSignedWide(std::int64_t value) noexcept
      : bits(static_cast<std::uint64_t>(value), value < 0 ? ~std::uint64_t(0) : 0) {}
  constexpr explicit PortableSignedWide(PortableWide value) noexcept : bits(value) {}

  [[nodiscard]] constexpr explicit operator PortableWide() const noexcept { return bits; }
  [[nodiscard]] constexpr explicit operator std::uint64_t() const noexcept { return bits.low; }
  [[nodiscard]] constexpr explicit operator std::int64_t() const noexcept { return static_cast<std::int64_t>(bits.low); }

  [[nodiscard]] friend constexpr PortableSignedWide operator+(PortableSignedWide a, PortableSignedWide b) noexcept {
    return PortableSignedWide(a.bits + b.bits);
  }
  [[nodiscard]] friend constexpr PortableSignedWide operator*(PortableSignedWide a, PortableSignedWide b) noexcept {
    return PortableSignedWide(a.bits * b.bits);
  }
  /// Rounded down; 0 < shift < 64.
  [[nodiscard]] friend constexpr PortableSignedWide operator>>(PortableSignedWide a, int shift) noexcept {
    const auto high = static_cast<std::int64_t>(a.bits.high);
    return PortableSignedWide(
        PortableWide((a.bits.low >> shift) | (a.bits.high << (64 - shift)), static_cast<std::uint64_t>(high >> shift)));
  }
  [[nodiscard]] friend constexpr bool operator==(PortableSignedWide a, PortableSignedWide b) noexcept = default;
  [[nodiscard]] friend constexpr std::strong_ordering operator<=>(PortableSignedWide a, PortableSignedWide b) noexcept {
    const auto a_high = static_cast<std::int64_t>(a.bits.high), b_high = static_cast<std::int64_t>(b.bits.high);
    return a_high != b_high ? a_high <=> b_high : a.bits.low <=> b.bits.low;
  }
};

}  // namespace graze::numeric
