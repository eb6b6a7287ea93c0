// The order of hits by integers from the bits of the input.
#include "exact/order.hpp"

#include <algorithm>

#include "exact/first_value.hpp"

namespace graze::exact {
namespace {

using numeric::dyadic;
using numeric::DyadicVec3;

struct RayInput {
  DyadicVec3 origin, direction;
  Range range;
};

struct ShapeInput {
  DyadicVec3 points[3];  ///< the corners, or the center thrice
  Dyadic radius;
  bool is_sphere;
};

template <Real T>
RayInput input(const Ray<T>& ray) noexcept {
  return {dyadic(ray.origin), dyadic(ray.direction), range(ray.t_min, ray.t_max)};
}

template <Real T>
ShapeInput input(const Triangle<T>& t) noexcept {
  return {{dyadic(t.a), dyadic(t.b), dyadic(t.c)}, {}, false};
}

template <Real T>
ShapeInput input(const Sphere<T>& s) noexcept {
  const DyadicVec3 center = dyadic(s.center);
  return {{center, center, center}, dyadic(s.radius), true};
}

struct Units {
  Extent positions, directions;
};

Units units(const RayInput& ray) noexcept {
  Units u;
  u.positions.include(ray.origin);
  u.directions.include(ray.direction);
  return u;
}

void include(Units& units, const ShapeInput& shape) noexcept {
  for (const DyadicVec3& p : shape.points) units.positions.include(p);
  units.positions.include(shape.radius);
}

template <int K>
IntegerRay<K> integer_ray(const RayInput& ray, const Units& units) noexcept {
  const int position = units.positions.low, direction = units.directions.low;
  return {integer_vec3<K>(ray.origin, position), integer_vec3<K>(ray.direction, direction), position, position - direction,
          ray.range};
}

template <int K>
void set_first(FirstValue<K>& out, const IntegerRay<K>& ray, const ShapeInput& shape) noexcept {
  if (shape.is_sphere) return set_first(out, ray, shape.points[0], shape.radius);
  set_first(out, ray, shape.points);
}

/// The bits of sign * mantissa * 2^exponent rounded toward or away from zero; no subnormal comes out.
double bounded(std::uint64_t mantissa, int exponent, bool away) noexcept {
  if (mantissa == 0) return 0;
  const int shift = std::bit_width(mantissa) - 53;
  std::uint64_t kept = shift > 0 ? mantissa >> shift : mantissa << -shift;
  if (away && shift > 0) ++kept;
  // A carry into 2^53 moves into the exponent field by itself.
  const std::int64_t field = std::int64_t(exponent) + shift + 1075;
  constexpr std::uint64_t infinity = numeric::infinity_bits<double>, hidden = std::uint64_t(1) << 52;
  if (field <= 0) return away ? 0x1p-1022 : 0;
  if (field >= 2047) return std::bit_cast<double>(away ? infinity : infinity - 1);
  return std::bit_cast<double>((static_cast<std::uint64_t>(field) << 52) + (kept - hidden));
}

Enclosure enclose(const Approximation& a, std::uint64_t slack) noexcept {
  if (a.sign == 0) return {0, 0};
  const std::uint64_t top = ~std::uint64_t(0);
  const double low = bounded(a.mantissa - slack, a.exponent, false);
  const double high = bounded(a.mantissa > top - slack ? top : a.mantissa + slack, a.exponent, true);
  return a.sign < 0 ? Enclosure{-high, -low} : Enclosure{low, high};
}

Enclosure enclose(const Dyadic& x) noexcept {
  const int shift = std::countl_zero(x.mantissa) & 63;
  return enclose({x.mantissa << shift, x.exponent - shift, x.sign()}, 0);
}

Enclosure enclose(const RayInput& ray, const ShapeInput& shape) noexcept {
  Units all = units(ray);
  include(all, shape);
  const int width = std::max(all.positions.width(), all.directions.width());
  return with_tier(width, [&]<int K>() {
    FirstValue<K> value;
    set_first(value, integer_ray<K>(ray, all), shape);
    using Form = typename FirstValue<K>::Form;
    if (value.form == Form::start) return enclose(ray.range.t_min);
    const Approximation a = value.form == Form::root ? value.root().approximation() : value.quotient->approximation();
    return enclose(a, Approximation::slack);
  });
}

int compare(const RayInput& ray, const ShapeInput& one, const ShapeInput& other) noexcept {
  Units all = units(ray);
  include(all, one);
  include(all, other);
  const int width = std::max(all.positions.width(), all.directions.width());
  return with_tier(width, [&]<int K>() {
    const IntegerRay<K> integers = integer_ray<K>(ray, all);
    FirstValue<K> first, second;
    set_first(first, integers, one);
    set_first(second, integers, other);
    return compare(first, second, ray.range);
  });
}

}  // namespace

template <Real T, template <class> class Shape>
Enclosure enclose_first(const Ray<T>& ray, const Shape<T>& shape) noexcept {
  return enclose(input(ray), input(shape));
}

template <Real T, template <class> class One, template <class> class Other>
int compare_first(const Ray<T>& ray, const One<T>& one, const Other<T>& other) noexcept {
  return compare(input(ray), input(one), input(other));
}

template Enclosure enclose_first(const Ray<float>&, const Triangle<float>&) noexcept;
template Enclosure enclose_first(const Ray<float>&, const Sphere<float>&) noexcept;
template Enclosure enclose_first(const Ray<double>&, const Triangle<double>&) noexcept;
template Enclosure enclose_first(const Ray<double>&, const Sphere<double>&) noexcept;
template int compare_first(const Ray<float>&, const Triangle<float>&, const Triangle<float>&) noexcept;
template int compare_first(const Ray<float>&, const Triangle<float>&, const Sphere<float>&) noexcept;
template int compare_first(const Ray<float>&, const Sphere<float>&, const Triangle<float>&) noexcept;
template int compare_first(const Ray<float>&, const Sphere<float>&, const Sphere<float>&) noexcept;
template int compare_first(const Ray<double>&, const Triangle<double>&, const Triangle<double>&) noexcept;
template int compare_first(const Ray<double>&, const Triangle<double>&, const Sphere<double>&) noexcept;
template int compare_first(const Ray<double>&, const Sphere<double>&, const Triangle<double>&) noexcept;
template int compare_first(const Ray<double>&, const Sphere<double>&, const Sphere<double>&) noexcept;

}  // namespace graze::exact
