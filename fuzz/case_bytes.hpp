// Cases as bytes, for fuzzers: every string of bytes is a case, and every case is some string.
//
// The first byte: bits 0-2 the query within its group, modulo the group's number; bit 3 double, not float; bit 4 a ray's range
// is given; bit 5 the compact form; bit 6 its exponents are eightfold. Then the numbers of the case line, little-endian: their
// bits, or, in the compact form, three signed bytes of exponents, for positions, for the direction or coefficients, and for the
// range, and then one signed byte m a number, which stands for m 2^exponent (127 as t_max: infinity). So small integers, whose
// cases are often degenerate, are one byte away from one another. What is missing at the end is read as zero, what is left over
// is not read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "fuzz/case.hpp"

namespace graze::fuzz {

using AnyCase = std::variant<Case<float>, Case<double>>;

/// The queries that a string of bytes may be: what one fuzz target is about.
enum class QueryGroup {
  ray_sphere,
  ray_triangle,
  implicit,  ///< point_line, point_plane, point_sphere
};

/// The group of an alternative of Case, by its index.
[[nodiscard]] constexpr QueryGroup group_of(std::size_t query) {
  return query == 0 ? QueryGroup::ray_sphere : query == 1 ? QueryGroup::ray_triangle : QueryGroup::implicit;
}

[[nodiscard]] AnyCase decode_case(QueryGroup group, std::span<const std::uint8_t> bytes);

/// Bytes that decode to just this case, bit by bit, in its own group: compact where that is exact.
template <Real T>
[[nodiscard]] std::vector<std::uint8_t> encode_case(const Case<T>& input);

}  // namespace graze::fuzz
