// Numbers that span as many bits as a tier of the exact stage holds, or one more: all of them as large as they get.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "fuzz/case_numbers.hpp"
#include "tests/support/agreement.hpp"
#include "tests/support/bit_patterns.hpp"

namespace graze::test {

/// Around 64 K - 4 for the tiers K = 1, 2, 5, 12, and all of double.
inline constexpr std::array tier_widths{59,  60,  61,  62,  63,  64,  123, 124, 125,  127, 128,
                                        315, 316, 317, 320, 763, 764, 765, 768, 2097, 2098};

/// Each number of the query, the ray's range apart: mostly the greatest of that width, of either sign; now and then the least,
/// or any.
template <Real T, class Query>
void fill_to_width(Query& query, int width, fuzz::Random& random) {
  constexpr int digits = std::numeric_limits<T>::digits;
  constexpr int lowest = std::numeric_limits<T>::min_exponent - digits, highest = std::numeric_limits<T>::max_exponent;
  const int low = random.between(lowest, highest - width), top = low + width - 1;
  fuzz::for_each_number(query, [&](T& x) {
    const auto choice = random.below(16);
    // All ones down to the unit of the least, or a full mantissa.
    const T greatest = std::ldexp(T(1), top) + (std::ldexp(T(1), top) - std::ldexp(T(1), std::max(top - digits + 1, low)));
    x = choice == 0 ? T(0) : choice <= 3 ? std::ldexp(T(1), low) : choice <= 5 ? std::ldexp(T(1), top) : greatest;
    x *= static_cast<T>(random.sign());
  });
  if constexpr (requires { query.sphere; }) query.sphere.radius = std::fabs(query.sphere.radius);
  if constexpr (requires { query.ray; }) {
    query.ray.t_min = static_cast<T>(-random.between(0, 3));
    query.ray.t_max = random.one_in(2) ? static_cast<T>(random.between(0, 3)) : std::numeric_limits<T>::infinity();
    // In a direction of its own width, as the kernel has it.
    if (random.one_in(4)) query.ray.direction = {static_cast<T>(random.between(-3, 3)), 1, static_cast<T>(random.sign())};
  }
}

/// Requires agreement at the ends of each tier that the format reaches.
template <template <class> class Query>
void require_agreement_at_tier_ends(int cases_a_width) {
  in_both_formats([&]<Real T>() {
    constexpr std::uint64_t seed = 132;
    CAPTURE(seed);
    fuzz::Random random(seed, "tiers", sizeof(T));
    for (const int width : tier_widths) {
      if (width > std::numeric_limits<T>::max_exponent - std::numeric_limits<T>::min_exponent + std::numeric_limits<T>::digits)
        continue;
      for (int i = 0; i < cases_a_width; ++i) {
        Query<T> query{};
        fill_to_width<T>(query, width, random);
        require_agreement(fuzz::Case<T>(query));
      }
    }
  });
}

}  // namespace graze::test
