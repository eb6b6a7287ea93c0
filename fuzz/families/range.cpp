// range. Every lattice times 2^k, positions and directions apart, from the least subnormal up to the largest numbers; triangles
// with exponents of their own along each axis (an affine map, so the promise stays); spheres likewise (it does not), and with
// r^2 beyond the range; and numbers of random bits. Squares, cubes and fourth powers of coordinates under- and overflow here
// while the answer is as plain as ever.
#include "fuzz/families/coordinates.hpp"
#include "fuzz/families/drafts.hpp"
#include "fuzz/families/finish.hpp"
#include "fuzz/families/registry.hpp"

namespace graze::fuzz::construct {

namespace {

/// A finite number of random bits; exponents are uniform, now and then at one end of the range, zero or a power of two.
template <Real T>
T random_number(Random& random) {
  const auto bits = static_cast<Bits<T>>(random.bits());
  const T number = std::bit_cast<T>(bits);
  const Bits<T> mantissa = bits & ((Bits<T>(1) << (digits<T> - 1)) - 1);
  switch (random.below(12)) {
    case 0:
      return std::bit_cast<T>(mantissa);
    case 1:
      return step(std::bit_cast<T>(static_cast<Bits<T>>((bits & sign_bit<T>) | mantissa)), random.sign());
    case 2:
      return is_finite(number) ? std::bit_cast<T>(static_cast<Bits<T>>(bits ^ mantissa)) : T(0);
    case 3:
      return T(0);
    default:
      return is_finite(number) ? number : step(std::numeric_limits<T>::max(), 0);
  }
}

template <Real T>
Case<T> random_bits_case(Random& random, bool is_triangle) {
  Case<T> input;
  if (is_triangle) input = RayTriangle<T>{};
  const Coordinates<T> all = coordinates(input);
  for (std::size_t i = 0; i < all.count; ++i) *all.at[i] = random_number<T>(random);
  if (all.radius < all.count && *all.at[all.radius] < T(0)) *all.at[all.radius] = negated(*all.at[all.radius]);
  // Some share most of their numbers, so that they meet at all.
  if (random.one_in(2)) {
    for (std::size_t i = 6; i < 9; ++i) *all.at[i] = *all.at[i - (random.one_in(2) ? 3 : 6)];
  }
  Vec3<T>& d = ray_of(input)->direction;
  if (is_zero(d.x) && is_zero(d.y) && is_zero(d.z)) d.x = std::numeric_limits<T>::denorm_min();
  return input;
}

struct RangeFamily {
  static constexpr std::string_view name = "range";
  static constexpr std::string_view attacks = "exponents at both ends, mixed exponents, random bits";
  static constexpr Note note{"squares and triple products beyond the exponents",
                             "everything lost for very small or very large scenes",
                             "AMReX-Codes/amrex issue 5789; g-truc/glm pull request 1158: small coordinates never hit"};
  template <Real T>
  static LabelledCase<T> make(Random& random, std::uint64_t index) {
    const bool is_triangle = is_triangle_index(index);
    if (index % 4 == 3) {
      LabelledCase<T> result;
      result.input = random_bits_case<T>(random, is_triangle);
      return result;
    }
    Plan plan;
    plan.reach = Reach::everything;
    plan.mixed_axes = is_triangle ? random.one_in(2) : random.one_in(6);
    return finish<T>(any_draft(random, digits<T>, is_triangle), random, index, plan);
  }
};

}  // namespace

Family range_family() {
  return family_of<RangeFamily>();
}

}  // namespace graze::fuzz::construct
