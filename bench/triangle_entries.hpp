// Who answers rays and triangles.
#pragma once

#include <vector>

#include "bench/entry.hpp"

namespace graze::bench {

/// In the format T; the forms in wider types are in double's.
template <Real T>
[[nodiscard]] std::vector<Entry<fuzz::RayTriangle<T>>> triangle_entries();

}  // namespace graze::bench
