// A boundary family: inputs that are on the edge by construction, or a hair off it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "fuzz/case.hpp"

namespace graze::fuzz {

/// What the construction promises of an un-nudged case; the oracle confirms it in the tests.
struct Label {
  std::optional<SphereKind> sphere;      ///< tangent, secant, miss
  std::optional<TriangleKind> triangle;  ///< the exact kind
  std::optional<Sign> side = {};         ///< of an implicit surface
  std::optional<Status> status = {};     ///< of an input that is invalid, or looks so
};

template <Real T>
struct LabelledCase {
  Case<T> input;
  Label label;  ///< empty where the case was nudged, rounded or has no promise
};

/// What a failure in a family means to who uses the kernel.
struct Note {
  std::string_view bug;        ///< the kind of bug
  std::string_view effect;     ///< what users see of it
  std::string_view published;  ///< where such a failure was reported, or that none was seen
};

/// Case `index` of stream `seed` is a function of (seed, index) alone: no other case need be made first.
struct Family {
  std::string_view name;     ///< kebab-case, as `--families` takes it
  std::string_view attacks;  ///< one line: what breaks here
  Note note;
  LabelledCase<float> (*make_float)(std::uint64_t seed, std::uint64_t index);
  LabelledCase<double> (*make_double)(std::uint64_t seed, std::uint64_t index);
};

/// All families, in the order of the reports.
[[nodiscard]] std::span<const Family> families();

/// The family of that name, or null.
[[nodiscard]] const Family* find_family(std::string_view name);

template <Real T>
[[nodiscard]] LabelledCase<T> make(const Family& family, std::uint64_t seed, std::uint64_t index) {
  if constexpr (std::same_as<T, float>) {
    return family.make_float(seed, index);
  } else {
    return family.make_double(seed, index);
  }
}

}  // namespace graze::fuzz
