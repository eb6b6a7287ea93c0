// A search for the input on which a filter errs the most, as a share of its bound.
#pragma once

#include <bit>
#include <cstdio>
#include <string_view>
#include <vector>

#include "fuzz/case_numbers.hpp"
#include "fuzz/case_text.hpp"
#include "tests/catch.hpp"
#include "tests/support/bit_patterns.hpp"

namespace graze::test {

inline constexpr std::uint64_t climb_seed = 52;

/// One change of one number: a bit, an ulp, a power of two and a bit more, nearly nothing, another number of the query.
template <class Query>
void mutate(Query& query, fuzz::Random& random) {
  std::vector<double*> numbers;
  fuzz::for_each_number(query, [&](double& x) { numbers.push_back(&x); });
  // A ray's range is of no concern here.
  if constexpr (requires { query.ray; }) numbers.resize(numbers.size() - 2);
  double& x = *numbers[random.below(numbers.size())];
  const double other = *numbers[random.below(numbers.size())];
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
      x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ std::uint64_t(1) << random.below(52));
      break;
    case 3:
      x = std::nextafter(x, random.one_in(2) ? -8 : 8);
      break;
    case 4:
      x = std::ldexp(1 + static_cast<double>(random.below(16)) * 0x1p-52, random.between(-2, 1)) * random.sign();
      break;
    case 5:
      x = std::ldexp(random.sign(), -random.between(20, 90));
      break;
    case 6:
      x = random.one_in(2) ? other : -other;
      break;
    default:
      x = random_of_size<double>(random, random.between(-2, 1));
      break;
  }
}

/// The greatest share that `share_of(query)` reaches in `steps` steps, which are never downhill, from some random starts; less
/// than `least` is a failure of the search.
template <class Query, class Share>
double climb(std::string_view name, int steps, Share share_of, double least = 0.02) {
  CAPTURE(name, climb_seed);
  constexpr int starts = 6;
  double greatest = 0;
  Query worst;
  for (int start = 0; start < starts; ++start) {
    fuzz::Random random(climb_seed, name, static_cast<std::uint64_t>(start));
    Query query{};
    fuzz::for_each_number(query, [&](double& x) { x = random_of_size<double>(random, 0); });
    if constexpr (requires { query.ray; }) query.ray = {query.ray.origin, query.ray.direction};
    if constexpr (requires { query.sphere; }) query.sphere.radius = std::fabs(query.sphere.radius);
    double share = share_of(query);
    for (int step = 0; step < steps / starts; ++step) {
      Query next = query;
      for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes) mutate(next, random);
      const double next_share = share_of(next);
      if (next_share < share) continue;
      share = next_share;
      query = next;
    }
    if (share <= greatest) continue;
    greatest = share;
    worst = query;
  }
  std::printf("%.*s: at most %.4f of the bound\n", static_cast<int>(name.size()), name.data(), greatest);
  INFO("worst " << fuzz::format_case(fuzz::Case<double>(worst)));
  CHECK(greatest <= 1);
  CHECK(greatest >= least);
  return greatest;
}

}  // namespace graze::test
