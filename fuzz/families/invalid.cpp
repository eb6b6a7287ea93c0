// invalid. Exact cases spoilt in one to four ways at once: a NaN (either sign, any payload) or an infinity in any number, a
// zero direction with zeros of either sign, a negative radius down to the least subnormal, a t_min above t_max by one ulp or by
// all there is. The status is the first of the contract's order. One in eight only looks invalid: -0 for a radius, a range of
// one point, an infinite t_max.
#include <limits>

#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

template <Real T>
T not_a_number(Random& random) {
  const auto payload = static_cast<Bits<T>>(random.bits()) & ((Bits<T>(1) << (digits<T> - 1)) - 1);
  const Bits<T> sign = random.one_in(2) ? sign_bit<T> : 0;
  return std::bit_cast<T>(static_cast<Bits<T>>(infinity_bits<T> | sign | (payload == 0 ? 1 : payload)));
}

template <Real T>
T random_zero(Random& random) {
  return random.one_in(2) ? T(0) : negated(T(0));
}

/// A NaN, or an infinity where none may be.
template <Real T>
void spoil_number(Case<T>& input, Random& random) {
  Coordinates<T> all = coordinates(input);
  const Ray<T>* ray = ray_of(input);
  if (ray != nullptr) all.count += 2;
  T& number = *all.at[random.below(all.count)];
  const T infinity = std::numeric_limits<T>::infinity();
  const bool is_end = ray != nullptr && &number == &ray->t_max;
  switch (random.below(3)) {
    case 0:
      number = not_a_number<T>(random);
      break;
    case 1:
      number = is_end ? -infinity : infinity;
      break;
    default:
      number = -infinity;
      break;
  }
}

template <Real T>
void spoil_direction(Ray<T>& ray, Random& random) {
  ray.direction.x = random_zero<T>(random);
  ray.direction.y = random_zero<T>(random);
  ray.direction.z = random_zero<T>(random);
}

template <Real T>
void spoil_radius(T& radius, Random& random) {
  const bool is_tiny = is_zero(radius) || random.one_in(3);
  radius = is_tiny ? -std::numeric_limits<T>::denorm_min() : negated(radius);
}

/// t_min above t_max.
template <Real T>
void spoil_range(Ray<T>& ray, Random& random) {
  constexpr T most = std::numeric_limits<T>::max();
  const int exponent = random.between(-digits<T>, 4);
  const Int mantissa = choose_integer(random, digits<T>);
  bool exact = true;
  ray.t_max = scaled<T>(mantissa, exponent, exact);
  ray.t_min = step(ray.t_max, 1);
  switch (random.below(4)) {
    case 0:
      ray.t_min = most;
      break;
    case 1:
      ray.t_max = -most;
      break;
    case 2:
      ray.t_max = step(T(0), -1);
      ray.t_min = random_zero<T>(random);
      break;
    default:
      break;
  }
}

template <Real T>
void make_look_invalid(Case<T>& input, Random& random) {
  const Coordinates<T> all = coordinates(input);
  if (all.radius < all.count && random.one_in(2)) *all.at[all.radius] = negated(T(0));
  Ray<T>* ray = ray_of(input);
  if (ray == nullptr) return;
  const bool is_line = random.one_in(2);
  ray->t_min = is_line ? -std::numeric_limits<T>::max() : random_zero<T>(random);
  if (!is_line) ray->t_max = random_zero<T>(random);
}

/// A valid case of any query.
template <Real T>
Case<T> valid_case(Random& random) {
  const std::uint64_t query = random.below(8);
  if (query < 3) {
    const std::uint64_t seed = random.bits();
    return make<T>(implicit_family(), seed, 4 * query).input;
  }
  const Draft draft = any_draft(random, digits<T>, query % 2 == 1);
  return finish<T>(draft, random, Plan{}).input;
}

struct Invalid {
  static constexpr std::string_view name = "invalid";
  static constexpr std::string_view attacks = "every kind of invalid input, several at once: the order of statuses";
  static constexpr Note note{"no check of the input, or in no fixed order",
                             "a crash, a hang, or NaN that is compared and passes for a hit",
                             "defold/defold pull request 11357: a ray of length zero crashes"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    LabelledCase<T> result;
    result.input = valid_case<T>(random);
    result.label.status = Status::ok;
    if (index % 8 == 7) {
      make_look_invalid(result.input, random);
      return result;
    }
    const std::uint64_t some = random.bits();
    const std::uint64_t faults = some & (some >> 32);  // each fault once in four
    Ray<T>* ray = ray_of(result.input);
    const Coordinates<T> all = coordinates(result.input);
    if (ray != nullptr && (faults & 1) != 0) {
      spoil_range(*ray, random);
      result.label.status = Status::empty_range;
    }
    if (all.radius < all.count && (faults & 2) != 0) {
      spoil_radius(*all.at[all.radius], random);
      result.label.status = Status::negative_radius;
    }
    if (ray != nullptr && (faults & 4) != 0) {
      spoil_direction(*ray, random);
      result.label.status = Status::zero_direction;
    }
    if ((faults & 8) != 0 || result.label.status == Status::ok) {
      spoil_number(result.input, random);
      result.label.status = Status::non_finite;
    }
    return result;
  }
};

}  // namespace

Family invalid_family() {
  return family_of<Invalid>();
}

}  // namespace graze::fuzz::construct
