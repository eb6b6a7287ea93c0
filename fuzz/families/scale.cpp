// How exponents are drawn.
#include "fuzz/families/scale.hpp"

#include <algorithm>

namespace graze::fuzz::construct {

namespace {

/// The exponents that keep every coordinate a finite multiple of the least subnormal.
struct Limits {
  int low, high;
  [[nodiscard]] int clamp(int exponent) const { return std::clamp(exponent, low, high); }
};

template <Real T>
int modest_exponent(Random& random, Limits limits) {
  return limits.clamp(random.between(-digits<T>, digits<T>));
}

/// Near the exponents at which products of two, three or four such numbers underflow or overflow.
template <Real T>
int product_exponent(Random& random, Limits limits) {
  const int end = random.one_in(2) ? least_exponent<T> : end_exponent<T>;
  const int factors = random.between(2, 4);
  const int off = random.between(-digits<T>, digits<T>);
  return limits.clamp(end / factors + off);
}

template <Real T>
int wild_exponent(Random& random, Limits limits) {
  switch (random.below(6)) {
    case 0:
      return limits.clamp(limits.low + random.between(0, digits<T> + 8));
    case 1:
      return limits.clamp(limits.high - random.between(0, digits<T> + 8));
    case 2:
      return random.between(limits.low, limits.high);
    case 3:
      return modest_exponent<T>(random, limits);
    default:
      return product_exponent<T>(random, limits);
  }
}

template <Real T>
int end_of_range(Random& random, Limits limits) {
  const int in = random.between(0, digits<T> + 8);
  return limits.clamp(random.one_in(2) ? limits.low + in : limits.high - in);
}

struct Exponents {
  int position = 0, direction = 0;
};

template <Real T>
Exponents usual_exponents(Random& random, Limits positions, Limits directions) {
  Exponents chosen{positions.clamp(0), directions.clamp(0)};
  const std::uint64_t roll = random.below(16);
  if (roll < 7) return chosen;
  if (roll < 12) {
    chosen.position = modest_exponent<T>(random, positions);
    chosen.direction = modest_exponent<T>(random, directions);
  } else {
    chosen.position = wild_exponent<T>(random, positions);
    chosen.direction = wild_exponent<T>(random, directions);
  }
  return chosen;
}

template <Real T>
Exponents choose_exponents(Random& random, Limits positions, Limits directions, Reach reach) {
  Exponents chosen;
  switch (reach) {
    case Reach::usual:
      return usual_exponents<T>(random, positions, directions);
    case Reach::directions:
      chosen.position = modest_exponent<T>(random, positions);
      chosen.direction = random.one_in(4) ? product_exponent<T>(random, directions) : end_of_range<T>(random, directions);
      return chosen;
    case Reach::products:
      chosen.position = product_exponent<T>(random, positions);
      chosen.direction = random.one_in(2) ? product_exponent<T>(random, directions) : modest_exponent<T>(random, directions);
      return chosen;
    case Reach::everything:
      chosen.position = wild_exponent<T>(random, positions);
      chosen.direction = wild_exponent<T>(random, directions);
      return chosen;
  }
  return chosen;
}

}  // namespace

template <Real T>
Scale choose_scale(Random& random, const ScaleRequest& request) {
  Limits positions{least_exponent<T>, std::max(least_exponent<T>, end_exponent<T> - request.position_bits)};
  Limits directions{least_exponent<T>, std::max(least_exponent<T>, end_exponent<T> - request.direction_bits)};
  Exponents chosen;
  if (request.one_scale) {
    positions.high = directions.high = std::min(positions.high, directions.high);
    chosen = choose_exponents<T>(random, positions, directions, request.reach);
    chosen.direction = chosen.position;
  } else if (request.t_exponent) {
    const int t = std::clamp(*request.t_exponent, positions.low - directions.high, positions.high - directions.low);
    positions.low = std::max(positions.low, directions.low + t);
    positions.high = std::min(positions.high, directions.high + t);
    chosen.position = random.between(positions.low, positions.high);
    chosen.direction = chosen.position - t;
  } else {
    chosen = choose_exponents<T>(random, positions, directions, request.reach);
  }

  Scale scale;
  scale.length = chosen.position;
  scale.t = chosen.position - chosen.direction;
  const Limits shifts{std::max(positions.low - chosen.position, directions.low - chosen.direction),
                      std::min(positions.high - chosen.position, directions.high - chosen.direction)};
  const bool far = random.one_in(2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int shift = 0;
    if (request.mixed_axes) shift = far ? random.between(shifts.low, shifts.high) : modest_exponent<T>(random, shifts);
    scale.position[axis] = chosen.position + shift;
    scale.direction[axis] = chosen.direction + shift;
  }
  return scale;
}

template Scale choose_scale<float>(Random&, const ScaleRequest&);
template Scale choose_scale<double>(Random&, const ScaleRequest&);

}  // namespace graze::fuzz::construct
