// The errors of a campaign as a picture.
#pragma once

#include <string>

#include "fuzz/certify/tally.hpp"

namespace graze::fuzz {

/// An SVG element: how many answers have a worst number with an error of each power of two of ulps, on a logarithmic scale.
/// Empty where no numbers were compared.
[[nodiscard]] std::string error_histogram(const Tally& tally);

}  // namespace graze::fuzz
