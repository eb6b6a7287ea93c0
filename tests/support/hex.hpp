// Numbers as their bits are, for messages: Catch2 prints them in a few decimals.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace graze::test {

[[nodiscard]] inline std::string hex(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}

}  // namespace graze::test
