// What a subject does otherwise than the contract, and says so: allowed for where answers are judged, counted, listed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace graze::fuzz {

/// One way to deviate.
enum class Deviation : std::uint8_t {
  coplanar_is_miss,      ///< a ray in the triangle's plane is answered miss
  degenerate_is_miss,    ///< a triangle without area is answered miss
  edges_are_faces,       ///< a hit at an edge or a corner is answered face
  tangents_are_secants,  ///< a tangent is answered secant, with one or two values
  hit_or_miss,           ///< every hit is answered by one kind; of an interval its beginning is told
  nearest_root,          ///< of two roots in the range only the first is told
  no_root,               ///< not told which root a lone value is
  no_origin,             ///< not told where the origin lies
  no_facing,             ///< not told which side the ray comes from
  no_coordinates,        ///< u and v are not told
  invalid_unhandled,     ///< invalid input gets any answer
  inexact_numbers,       ///< a number is off by no more than its declared ulps, or is -0
};
inline constexpr std::size_t deviation_count = 12;

/// A set of deviations.
class DeviationSet {
 public:
  constexpr DeviationSet() = default;
  constexpr DeviationSet(std::initializer_list<Deviation> deviations) {
    for (const Deviation d : deviations) add(d);
  }
  constexpr void add(Deviation d) { bits_ |= 1u << static_cast<unsigned>(d); }
  [[nodiscard]] constexpr bool has(Deviation d) const { return (bits_ >> static_cast<unsigned>(d) & 1u) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  bool operator==(const DeviationSet&) const = default;

 private:
  std::uint32_t bits_ = 0;
};

/// What a subject declares. A correctly rounded number is off by at most 1/2 ulp of the exact value: that alone is demanded
/// where nothing more is declared. `inexact_numbers` follows from a limit above 1/2 and need not be in the set.
struct Deviations {
  DeviationSet set;
  double t_ulps = 0.5;   ///< t, t_end and the roots
  double uv_ulps = 0.5;  ///< u and v
};

/// What is declared, in the order of Deviation, with inexact_numbers where a limit says so.
[[nodiscard]] inline std::vector<Deviation> declared_deviations(const Deviations& declared) {
  std::vector<Deviation> all;
  for (std::size_t i = 0; i < deviation_count; ++i) {
    const auto d = static_cast<Deviation>(i);
    const bool by_limit = d == Deviation::inexact_numbers && (declared.t_ulps > 0.5 || declared.uv_ulps > 0.5);
    if (by_limit || declared.set.has(d)) all.push_back(d);
  }
  return all;
}

struct DeviationText {
  std::string_view name;   ///< in reports and in the handshake of a program
  std::string_view means;  ///< one clause
};

/// In the order of Deviation.
inline constexpr std::array<DeviationText, deviation_count> deviation_texts = {{
    {"coplanar-is-miss", "a ray in the triangle's plane is answered miss"},
    {"degenerate-is-miss", "a triangle without area is answered miss"},
    {"edges-are-faces", "a hit at an edge or a corner is answered face"},
    {"tangents-are-secants", "a tangent is answered secant"},
    {"hit-or-miss", "no kinds of hit are told apart"},
    {"nearest-root", "of two roots in the range only the first is told"},
    {"no-root", "which root a lone value is, is not told"},
    {"no-origin", "where the origin lies is not told"},
    {"no-facing", "which side the ray comes from is not told"},
    {"no-coordinates", "u and v are not told"},
    {"invalid-unhandled", "invalid input gets any answer"},
    {"inexact-numbers", "a number is off by no more than the declared ulps, or is -0"},
}};

[[nodiscard]] constexpr std::string_view name_of(Deviation d) {
  return deviation_texts[static_cast<std::size_t>(d)].name;
}

/// The deviation of that name.
[[nodiscard]] constexpr std::optional<Deviation> find_deviation(std::string_view name) {
  for (std::size_t i = 0; i < deviation_count; ++i) {
    if (deviation_texts[i].name == name) return static_cast<Deviation>(i);
  }
  return std::nullopt;
}

}  // namespace graze::fuzz
