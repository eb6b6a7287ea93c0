// A hash of inputs that adds up: the same cases give the same sum, in whatever order and on however many machines.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "fuzz/case_numbers.hpp"
#include "fuzz/mesh/mesh.hpp"

namespace graze::fuzz {

/// A hash of words in their order, each mixed in by the finisher of splitmix64.
class WordHash {
 public:
  constexpr void add(std::uint64_t word) {
    std::uint64_t z = state_ ^ word;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    state_ = (z ^ (z >> 31)) + 0x9e3779b97f4a7c15;
  }
  template <Real T>
  constexpr void add(T number) {
    add(std::uint64_t{std::bit_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(number)});
  }
  [[nodiscard]] constexpr std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

/// Of the query, the bits of its numbers and its place in its row. To be added modulo 2^64 to those of other cases.
template <Real T>
[[nodiscard]] std::uint64_t input_hash(const Case<T>& input, std::uint64_t index) {
  WordHash hash;
  hash.add(index);
  hash.add(std::uint64_t{input.index()});
  std::visit([&](const auto& query) { for_each_number(query, [&](T number) { hash.add(number); }); }, input);
  return hash.value();
}

/// Of the points and triangles, not of the name.
[[nodiscard]] inline std::uint64_t input_hash(const Mesh& mesh) {
  WordHash hash;
  for (const Vec3<double>& p : mesh.points) {
    hash.add(p.x);
    hash.add(p.y);
    hash.add(p.z);
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) hash.add(std::uint64_t{corner});
  }
  return hash.value();
}

}  // namespace graze::fuzz
