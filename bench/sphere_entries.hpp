// Who answers rays and spheres.
#pragma once

#include <vector>

#include "bench/entry.hpp"

namespace graze::bench {

/// In the format T; the forms in wider types are in double's.
template <Real T>
[[nodiscard]] std::vector<Entry<fuzz::RaySphere<T>>> sphere_entries();

}  // namespace graze::bench
