// One mutation of the bytes of a case, whatever fuzzer asks for it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/case_mutator.hpp"
#include "fuzz/targets/case_target.hpp"

namespace graze::fuzz {

/// The bytes of the case with one to three changes of its geometry.
[[nodiscard]] inline std::vector<std::uint8_t> mutated_bytes(std::span<const std::uint8_t> bytes, Random& random) {
  return std::visit(
      [&](auto input) {
        for (int changes = random.between(1, 3); changes > 0; --changes) mutate(input, random);
        return encode_case(input);
      },
      decode_case(target_group, bytes));
}

}  // namespace graze::fuzz
