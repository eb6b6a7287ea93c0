// The exact stage of ray and sphere: integers from the bits of the input. No floating point decides anything here, so no
// rounding mode, flush-to-zero, underflow or overflow can touch it.
#include "graze/sphere.hpp"

#include "exact/quotient.hpp"
#include "exact/range.hpp"
#include "exact/root.hpp"
#include "exact/scaled.hpp"
#include "exact/validate.hpp"

namespace graze::exact {
namespace {

struct SphereInput {
  DyadicVec3 origin, direction, center;
  Dyadic radius;
  Range range;
};

/// A SphereHit whose numbers are bits of the format asked for.
struct SphereBits {
  SphereKind kind = SphereKind::miss;
  Root root = Root::none;
  OriginSide origin = OriginSide::inside;
  std::uint64_t t[2] = {};
};

enum class Wanted { decision, numbers };

/// With L = c - e: A = d.d, B = d.L, C = L.L - r^2, D = B^2 - A C over integers of K-limb coordinates.
template <int K>
SphereBits answer(const SphereInput& in, int position_unit, int direction_unit, const Format& format, Wanted wanted) noexcept {
  const IntegerVec3<K> l = integer_vec3<K>(in.center, position_unit) - integer_vec3<K>(in.origin, position_unit);
  const IntegerVec3<K> d = integer_vec3<K>(in.direction, direction_unit);
  const Integer<K> r = numeric::integer<K>(in.radius, position_unit);
  const Integer<2 *K> a = dot(d, d), b = dot(d, l), c = dot(l, l) - r * r;
  const Integer<4 * K> discriminant = b * b - a * c;
  const int scale = position_unit - direction_unit;

  SphereBits out;
  const int origin = c.sign();
  out.origin = origin < 0 ? OriginSide::inside : origin == 0 ? OriginSide::on : OriginSide::outside;
  const int sign = discriminant.sign();
  if (sign < 0) return out;
  if (sign == 0) {
    const Quotient<2 * K> t(b, a, scale);
    if (!in.range.contains(t)) return out;
    out.kind = SphereKind::tangent;
    out.root = Root::both;
    if (wanted == Wanted::numbers) out.t[0] = round_to_bits(t, format);
    return out;
  }
  const Quadratic<K> quadratic{a, b, c, discriminant, scale};
  const QuadraticRoot<K> first(quadratic, false), second(quadratic, true);
  const bool has_first = in.range.contains(first), has_second = in.range.contains(second);
  if (!has_first && !has_second) return out;
  out.kind = SphereKind::secant;
  out.root = has_first && has_second ? Root::both : has_first ? Root::first : Root::second;
  if (wanted == Wanted::decision) return out;
  int count = 0;
  if (has_first) out.t[count++] = round_to_bits(first, format);
  if (has_second) out.t[count] = round_to_bits(second, format);
  return out;
}

SphereBits answer(const SphereInput& in, const Format& format, Wanted wanted) noexcept {
  Extent positions, directions;
  positions.include(in.origin);
  positions.include(in.center);
  positions.include(in.radius);
  directions.include(in.direction);
  const int width = std::max(positions.width(), directions.width());
  return with_tier(width, [&]<int K>() { return answer<K>(in, positions.low, directions.low, format, wanted); });
}

template <Real T>
SphereInput input(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  using numeric::dyadic;
  return {dyadic(ray.origin), dyadic(ray.direction), dyadic(sphere.center), dyadic(sphere.radius), range(ray.t_min, ray.t_max)};
}

}  // namespace

template <Real T>
SphereHit<T> intersect(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  SphereHit<T> hit;
  hit.status = status_of(ray, sphere);
  if (hit.status != Status::ok) {
    hit.kind = SphereKind::invalid;
    return hit;
  }
  const SphereBits bits = answer(input(ray, sphere), numeric::format_of<T>, Wanted::numbers);
  hit.kind = bits.kind;
  hit.root = bits.root;
  hit.origin = bits.origin;
  hit.t[0] = std::bit_cast<T>(static_cast<numeric::Bits<T>>(bits.t[0]));
  hit.t[1] = std::bit_cast<T>(static_cast<numeric::Bits<T>>(bits.t[1]));
  return hit;
}

template <Real T>
bool hits(const Ray<T>& ray, const Sphere<T>& sphere) noexcept {
  if (status_of(ray, sphere) != Status::ok) return false;
  return answer(input(ray, sphere), numeric::format_of<T>, Wanted::decision).kind != SphereKind::miss;
}

template SphereHit<float> intersect(const Ray<float>&, const Sphere<float>&) noexcept;
template SphereHit<double> intersect(const Ray<double>&, const Sphere<double>&) noexcept;
template bool hits(const Ray<float>&, const Sphere<float>&) noexcept;
template bool hits(const Ray<double>&, const Sphere<double>&) noexcept;

}  // namespace graze::exact
