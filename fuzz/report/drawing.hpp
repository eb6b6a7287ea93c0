// A small picture of a case.
#pragma once

#include <string>

#include "fuzz/certify/check.hpp"

namespace graze::fuzz {

/// An SVG element and, below it, in words, from where it is seen and what in it is not to scale. Empty for a case that has no
/// picture: one about a point, or with numbers that are not finite.
///
/// A sphere is drawn in the plane of the ray and its center. A triangle is drawn as the ray sees it; where it would be too thin
/// or too far off, so that its corners are those of a fixed triangle, in u and v; where the ray runs along its plane, from
/// above.
[[nodiscard]] std::string drawing(const Offender& offender);

}  // namespace graze::fuzz
