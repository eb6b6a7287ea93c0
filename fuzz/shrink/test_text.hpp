// A case as a Catch2 test of graze, to paste into a suite.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// A TEST_CASE of that title which asks the kernel about the case, in C++ that needs graze's headers and <limits>, and checks
/// every part of the answer that has a meaning, bit by bit but for the sign of zero. Numbers are hexadecimal literals.
template <Real T>
[[nodiscard]] std::string catch_test(std::string_view title, const Case<T>& input, const Answer<T>& truth);

}  // namespace graze::fuzz
