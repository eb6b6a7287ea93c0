// A stream of random bits that is a function of (seed, stream name, index) alone: case n needs no case before it, and every
// compiler and standard library gives the same bits (no std::uniform_*_distribution, no floating point).
// Callers draw once a statement: the order in which C++ evaluates arguments and operands is unspecified.
#pragma once

#include <cstdint>
#include <string_view>

namespace graze::fuzz {

class Random {
 public:
  constexpr Random(std::uint64_t seed, std::string_view stream, std::uint64_t index) : key_(mix(seed)) {
    for (const char letter : stream) key_ = mix(key_ ^ static_cast<unsigned char>(letter));
    state_ = mix(key_ ^ mix(index));
  }

  /// The stream of the same seed and name at another index.
  [[nodiscard]] constexpr Random at(std::uint64_t index) const {
    Random other = *this;
    other.state_ = mix(key_ ^ mix(index));
    return other;
  }

  /// 64 random bits (splitmix64).
  constexpr std::uint64_t bits() {
    state_ += golden;
    return mix(state_);
  }

  /// A number in [0, n); n > 0. The bias of n / 2^64 does not matter here.
  constexpr std::uint64_t below(std::uint64_t n) {
    __extension__ typedef unsigned __int128 Wide;
    return static_cast<std::uint64_t>((static_cast<Wide>(bits()) * n) >> 64);
  }

  /// A number in [low, high], both included; low where the interval is empty.
  constexpr int between(int low, int high) {
    if (high < low) return low;
    const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low) + 1;
    return static_cast<int>(low + static_cast<std::int64_t>(below(span)));
  }

  /// True once in n.
  constexpr bool one_in(std::uint64_t n) { return below(n) == 0; }

  /// +1 or -1.
  constexpr int sign() { return (bits() >> 63) != 0 ? -1 : 1; }

 private:
  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
  std::uint64_t state_ = 0;
};

}  // namespace graze::fuzz
