// Ranges of the ray parameter whose ends lie at, one ulp around and between the parameters of the hits.
#pragma once

#include "fuzz/case.hpp"
#include "fuzz/families/draft.hpp"
#include "fuzz/random.hpp"

namespace graze::fuzz::construct {

/// Numbers of the format that are or lie beside the parameters of the hits.
template <Real T>
struct Guesses {
  std::array<T, 2> at{};
  int count = 0;
};

/// The numbers nearest to the marks times 2^exponent, or next to nearest.
template <Real T>
[[nodiscard]] Guesses<T> guesses(const Marks& marks, int exponent);

/// The roots as double precision computes them; none where it cannot.
template <Real T>
[[nodiscard]] Guesses<T> guesses(const RaySphere<T>& input);
template <Real T>
[[nodiscard]] Guesses<T> guesses(const RayTriangle<T>& input);

/// Gives the ray a range other than the default one; t_min <= t_max. Without guesses the ends are random.
template <Real T>
void choose_bounds(Ray<T>& ray, Guesses<T> near, Random& random);

/// The sign of x - mark * 2^exponent, exact; x is finite.
template <Real T>
[[nodiscard]] int compare(T x, const Mark& mark, int exponent);

}  // namespace graze::fuzz::construct
