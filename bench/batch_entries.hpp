// This library's batches as entries: pairs of a ray and a shape in arrays, in the vectors that the program is compiled for.
#pragma once

#include <vector>

#include "bench/entry.hpp"

namespace graze::bench {

/// None where Highway was not found.
template <class Query>
void add_batch_entries(std::vector<Entry<Query>>& entries);

}  // namespace graze::bench
