#include "fuzz/shrink/shrink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz/families/coordinates.hpp"
#include "fuzz/same_bits.hpp"

namespace graze::fuzz {
namespace {

constexpr std::uint64_t of_nan = 400000, of_infinity = 200000, of_nonzero = 4, of_bit = 4, of_sign = 1, of_end = 64;

/// The exponent of the leading bit; x is finite and not zero.
template <Real T>
int leading_exponent(T x) {
  int exponent = 0;
  static_cast<void>(std::frexp(x, &exponent));
  return exponent - 1;
}

/// How many bits there are from the first that is set to the last.
template <Real T>
int significant_bits(T x) {
  int exponent = 0, bits = 0;
  for (T m = std::abs(std::frexp(x, &exponent)); m != 0; ++bits) {
    m *= 2;
    m -= std::floor(m);
  }
  return bits;
}

template <Real T>
std::uint64_t complexity_of(T x) {
  const std::uint64_t sign = std::signbit(x) ? of_sign : 0;
  if (std::isnan(x)) return of_nan;
  if (std::isinf(x)) return of_infinity + sign;
  if (x == 0) return sign;
  return of_nonzero + of_bit * static_cast<std::uint64_t>(significant_bits(x)) +
         static_cast<std::uint64_t>(std::abs(leading_exponent(x))) + sign;
}

/// x at a multiple of 2^exponent, toward zero or away from it.
template <Real T>
T rounded_to(T x, int exponent, bool is_outward) {
  const T m = std::ldexp(x, -exponent);
  return std::ldexp(is_outward ? std::copysign(std::ceil(std::abs(m)), m) : std::trunc(m), exponent);
}

/// Numbers that belong together, by position; scaled by 2^k those that are `against` are scaled by 2^-k.
struct Group {
  std::vector<std::size_t> with, against;
};

/// Positions, by the first of their three numbers; what is scaled together; where a direction starts.
struct Layout {
  std::vector<std::size_t> points;
  std::vector<Group> groups;
  std::vector<std::size_t> vectors;
  bool has_ray = false;
};

Layout layout_of(std::size_t query) {
  switch (query) {
    case 0:
      return {{0, 6},
              {{{0, 1, 2, 6, 7, 8, 9, 10, 11}, {}}, {{3, 4, 5}, {10, 11}}, {{3, 4, 5}, {}}, {{6, 7, 8, 9}, {}}},
              {0, 3, 6},
              true};
    case 1:
      return {{0, 6, 9, 12},
              {{{0, 1, 2, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}, {}},
               {{3, 4, 5}, {15, 16}},
               {{3, 4, 5}, {}},
               {{6, 7, 8, 9, 10, 11, 12, 13, 14}, {}}},
              {0, 3, 6, 9, 12},
              true};
    case 2:
      return {{}, {{{0, 1, 4}, {}}, {{2, 3, 4}, {}}, {{0, 1}, {2, 3}}}, {}};
    case 3:
      return {{}, {{{0, 1, 2, 6}, {}}, {{3, 4, 5, 6}, {}}, {{0, 1, 2}, {3, 4, 5}}}, {0, 3}};
    default:
      return {{0, 3}, {{{0, 1, 2, 3, 4, 5, 6}, {}}}, {0, 3}};
  }
}

template <Real T>
class Shrinker {
 public:
  Shrinker(const Case<T>& input, const Fails<T>& fails, std::uint64_t most)
      : best_(input), cost_(complexity(input)), fails_(fails), most_(most), layout_(layout_of(input.index())) {}

  Shrunk<T> run() {
    for (bool is_changed = true; is_changed;) {
      // The changes of many numbers first: they take the most away.
      is_changed = range();
      is_changed |= vectors();
      is_changed |= translations();
      is_changed |= reflections();
      is_changed |= scales();
      is_changed |= lattices();
      is_changed |= numbers();
    }
    return {best_, trials_, trials_ < most_};
  }

 private:
  using Coordinates = construct::Coordinates<T>;

  /// Changes a copy, and takes it where it is simpler and still fails.
  template <class Change>
  bool attempt(Change change) {
    Case<T> changed = best_;
    change(construct::coordinates(changed));
    const std::uint64_t cost = complexity(changed);
    if (cost >= cost_ || trials_ >= most_) return false;
    ++trials_;
    if (!fails_(changed)) return false;
    best_ = changed;
    cost_ = cost;
    return true;
  }
  /// The number at i in the best case so far.
  T number(std::size_t i) { return *construct::coordinates(best_).at[i]; }
  std::size_t count() { return construct::coordinates(best_).count; }

  bool range() {
    if (!layout_.has_ray) return false;
    const std::size_t first = count();
    bool is_changed = attempt([&](const Coordinates& all) { *all.at[first] = 0; });
    is_changed |= attempt([&](const Coordinates& all) { *all.at[first + 1] = std::numeric_limits<T>::infinity(); });
    return is_changed;
  }

  /// Each vector zero, or along one axis.
  bool vectors() {
    bool is_changed = false;
    for (const std::size_t v : layout_.vectors) {
      for (std::size_t axis = 0; axis < 4; ++axis) {
        is_changed |= attempt([&](const Coordinates& all) {
          for (std::size_t k = 0; k < 3; ++k) {
            if (k != axis) *all.at[v + k] = 0;
          }
        });
      }
    }
    return is_changed;
  }

  /// Each point to the origin, with all others; the same in one axis alone; and the ray's origin along the ray.
  bool translations() {
    bool is_changed = false;
    for (const std::size_t p : layout_.points) {
      for (std::size_t axes = 7; axes != 0; axes = axes == 7 ? 4 : axes / 2) {
        is_changed |= attempt([&](const Coordinates& all) {
          const std::array<T, 3> by{*all.at[p], *all.at[p + 1], *all.at[p + 2]};
          for (const std::size_t q : layout_.points) {
            for (std::size_t k = 0; k < 3; ++k) {
              if (((axes >> k) & 1) != 0) *all.at[q + k] -= by[k];
            }
          }
        });
      }
    }
    if (!layout_.has_ray) return is_changed;
    for (const T way : {T(1), T(-1)}) {
      while (attempt([&](const Coordinates& all) {
        for (std::size_t k = 0; k < 3; ++k) *all.at[k] += way * *all.at[3 + k];
      })) {
        is_changed = true;
      }
    }
    return is_changed;
  }

  /// An axis of all vectors, or the direction, turned around.
  bool reflections() {
    bool is_changed = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      is_changed |= attempt([&](const Coordinates& all) {
        for (const std::size_t v : layout_.vectors) *all.at[v + axis] = -*all.at[v + axis];
      });
    }
    if (!layout_.has_ray) return is_changed;
    is_changed |= attempt([](const Coordinates& all) {
      for (std::size_t k = 3; k < 6; ++k) *all.at[k] = -*all.at[k];
    });
    return is_changed;
  }

  [[nodiscard]] bool is_scalable(std::size_t i) {
    const T x = number(i);
    return std::isfinite(x) && x != 0;
  }

  /// Each group times powers of two that take its largest or its least number nearer to units, as far as may be, or divided by
  /// a small odd number.
  bool scales() {
    bool is_changed = false;
    for (const Group& group : layout_.groups) {
      std::vector<int> exponents;
      for (const std::size_t i : group.with) {
        if (is_scalable(i)) exponents.push_back(leading_exponent(number(i)));
      }
      if (exponents.empty()) continue;
      const auto [low, high] = std::minmax_element(exponents.begin(), exponents.end());
      for (const int whole : {*low, *high}) {
        for (int step = whole; step != 0; step /= 2) {
          if (!attempt([&](const Coordinates& all) { scale(all, group, -step); })) continue;
          is_changed = true;
          break;
        }
      }
      for (const T odd : {T(15), T(7), T(5), T(3)}) {
        is_changed |= attempt([&](const Coordinates& all) {
          for (const std::size_t i : group.with) *all.at[i] /= odd;
        });
      }
    }
    return is_changed;
  }
  static void scale(const Coordinates& all, const Group& group, int exponent) {
    for (const std::size_t i : group.with) *all.at[i] = std::ldexp(*all.at[i], exponent);
    for (const std::size_t i : group.against) *all.at[i] = std::ldexp(*all.at[i], -exponent);
  }

  /// Each group on a coarser lattice: the coarsest that will do.
  bool lattices() {
    bool is_changed = false;
    for (const Group& group : layout_.groups) {
      int top = std::numeric_limits<int>::min();
      for (const std::size_t i : group.with) {
        if (is_scalable(i)) top = std::max(top, leading_exponent(number(i)));
      }
      if (top == std::numeric_limits<int>::min()) continue;
      for (int bits = 0; bits < std::numeric_limits<T>::digits; ++bits) {
        if (!attempt([&](const Coordinates& all) {
              for (const std::size_t i : group.with) {
                if (std::isfinite(*all.at[i])) *all.at[i] = rounded_to(*all.at[i], top - bits, false);
              }
            })) {
          continue;
        }
        is_changed = true;
        break;
      }
    }
    return is_changed;
  }

  bool numbers() {
    bool is_changed = false;
    const std::size_t all = count() + (layout_.has_ray ? 2 : 0);
    for (std::size_t i = 0; i < all; ++i) is_changed |= simplify(i);
    return is_changed;
  }
  bool replace(std::size_t i, T x) {
    return attempt([&](const Coordinates& all) { *all.at[i] = x; });
  }
  /// One number: the simplest first, so the first that will do is taken.
  bool simplify(std::size_t i) {
    for (const int small : {0, 1, -1, 2, -2, 3, -3, 4, 5, 6, 7, 8}) {
      if (replace(i, static_cast<T>(small))) return true;
    }
    const T x = number(i);
    if (!std::isfinite(x)) return replace(i, std::numeric_limits<T>::infinity());
    if (x == 0) return false;
    if (replace(i, std::abs(x))) return true;
    const int top = leading_exponent(x);
    for (int bits = 0; bits < std::numeric_limits<T>::digits; ++bits) {
      for (const bool is_outward : {false, true}) {
        if (replace(i, rounded_to(x, top - bits, is_outward))) return true;
      }
    }
    for (int step = top; step != 0; step /= 2) {
      if (replace(i, std::ldexp(x, -step))) return true;
    }
    return false;
  }

  Case<T> best_;
  std::uint64_t cost_, trials_ = 0;
  const Fails<T>& fails_;
  std::uint64_t most_;
  Layout layout_;
};

}  // namespace

template <Real T>
std::uint64_t complexity(const Case<T>& input) {
  Case<T> copy = input;
  const construct::Coordinates<T> all = construct::coordinates(copy);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < all.count; ++i) sum += complexity_of(*all.at[i]);
  if (const Ray<T>* ray = construct::ray_of(copy)) {
    if (!same_bits(ray->t_min, T(0))) sum += of_end + complexity_of(ray->t_min);
    if (!same_bits(ray->t_max, std::numeric_limits<T>::infinity())) sum += of_end + complexity_of(ray->t_max);
  }
  return sum;
}

template <Real T>
Shrunk<T> shrink(const Case<T>& input, const Fails<T>& fails, std::uint64_t trials) {
  return Shrinker<T>(input, fails, trials).run();
}

template std::uint64_t complexity(const Case<float>&);
template std::uint64_t complexity(const Case<double>&);
template Shrunk<float> shrink(const Case<float>&, const Fails<float>&, std::uint64_t);
template Shrunk<double> shrink(const Case<double>&, const Fails<double>&, std::uint64_t);

}  // namespace graze::fuzz
