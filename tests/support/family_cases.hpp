// The cases of all families, query by query.
#pragma once

#include <cstdint>

#include "fuzz/family.hpp"
#include "tests/catch.hpp"

namespace graze::test {

/// The seed of every test over families; a failure prints the case itself too.
inline constexpr std::uint64_t family_seed = 20261122;

/// Calls visit(query) for the cases 0 to count - 1 of each family that are a Query<T>; the failing case's family and index are
/// told.
template <template <class> class Query, Real T, class Visit>
void each_family_query(std::uint64_t count, Visit visit) {
  CAPTURE(family_seed);
  for (const fuzz::Family& family : fuzz::families()) {
    CAPTURE(family.name);
    for (std::uint64_t index = 0; index < count; ++index) {
      const fuzz::LabelledCase<T> made = fuzz::make<T>(family, family_seed, index);
      if (const auto* query = std::get_if<Query<T>>(&made.input)) visit(*query);
    }
  }
}

}  // namespace graze::test
