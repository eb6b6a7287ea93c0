// How numbers are moved by an ulp.
#include "fuzz/families/nudge.hpp"

#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/float_bits.hpp"

namespace graze::fuzz::construct {

namespace {

/// A zero becomes the least subnormal, a number of any small exponent, or an ulp of a number like `other`.
template <Real T>
T moved_zero(Random& random, T other) {
  bool exact = true;
  int exponent = least_exponent<T>;
  switch (random.below(4)) {
    case 0:
      exponent = random.between(least_exponent<T>, 0);
      break;
    case 1:
      exponent = parts(other).exponent;
      break;
    default:
      break;
  }
  return scaled<T>(random.sign(), exponent, exact);
}

template <Real T>
T moved(T x, Random& random, T other) {
  return is_zero(x) ? moved_zero(random, other) : step(x, random.sign());
}

template <Real T>
bool is_broken(Case<T>& input, const Coordinates<T>& all) {
  if (all.radius < all.count && *all.at[all.radius] < T(0)) return true;
  const Ray<T>* ray = ray_of(input);
  if (ray == nullptr) return false;
  const Vec3<T>& d = ray->direction;
  return (is_zero(d.x) && is_zero(d.y) && is_zero(d.z)) || ray->t_min > ray->t_max;
}

}  // namespace

template <Real T>
void nudge(Case<T>& input, Random& random, Nudged what) {
  Coordinates<T> all = coordinates(input);
  std::size_t count = what == Nudged::ray ? 6 : all.count;
  if (Ray<T>* ray = ray_of(input); ray != nullptr && what == Nudged::anything) {
    if (!is_zero(ray->t_min)) all.at[count++] = &ray->t_min;
    if (is_finite(ray->t_max)) all.at[count++] = &ray->t_max;
  }
  const int moves = random.between(1, 2);
  for (int move = 0; move < moves; ++move) {
    std::size_t which = random.below(count);
    const bool prefer_radius = random.one_in(6);
    if (prefer_radius && what == Nudged::anything && all.radius < all.count) which = all.radius;
    const T other = *all.at[random.below(count)];
    T& number = *all.at[which];
    const T old = number;
    number = moved(number, random, other);
    if (is_broken(input, all)) number = old;
  }
}

template <Real T>
void flip_zeros(Case<T>& input, Random& random) {
  const Coordinates<T> all = coordinates(input);
  const std::uint64_t chosen = random.bits();
  for (std::size_t i = 0; i < all.count; ++i) {
    if (is_zero(*all.at[i]) && ((chosen >> i) & 1) != 0) *all.at[i] = negated(*all.at[i]);
  }
}

template void nudge<float>(Case<float>&, Random&, Nudged);
template void nudge<double>(Case<double>&, Random&, Nudged);
template void flip_zeros<float>(Case<float>&, Random&);
template void flip_zeros<double>(Case<double>&, Random&);

}  // namespace graze::fuzz::construct
