// Cases as bytes, for fuzzers: every string of bytes is a case, and every case is some string.
//
// The first byte: bits 0-2 the query, modulo 5, in the order of Case; bit 3 double, not float; bit 4 a ray's range is given;
// bit 5 the compact form; bit 6 its exponents are eightfold. Then the numbers of the case line, little-endian: their bits, or,
// in the compact form, three signed bytes of exponents, for positions, for the direction or coefficients, and for the range,
// and then one signed byte m a number, which stands for m 2^exponent (127 as t_max: infinity). So small integers, whose cases
// are often degenerate, are one byte away from one another. What is missing at the end is read as zero, what is left over is
// not read.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "fuzz/case.hpp"

namespace graze::fuzz {

using AnyCase = std::variant<Case<float>, Case<double>>;

[[nodiscard]] AnyCase decode_case(std::span<const std::uint8_t> bytes);

/// Bytes that decode to just this case, bit by bit: compact where that is exact.
template <Real T>
[[nodiscard]] std::vector<std::uint8_t> encode_case(const Case<T>& input);

}  // namespace graze::fuzz
