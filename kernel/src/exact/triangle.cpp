// The exact stage of ray and triangle: integers from the bits of the input. No floating point decides anything here, so no
// rounding mode, flush-to-zero, underflow or overflow can touch it.
#include "graze/triangle.hpp"

#include <algorithm>

#include "exact/flat.hpp"
#include "exact/interval.hpp"
#include "exact/order.hpp"
#include "exact/quotient.hpp"
#include "exact/range.hpp"
#include "exact/scaled.hpp"
#include "exact/validate.hpp"

namespace graze::exact {
namespace {

struct TriangleInput {
  DyadicVec3 origin, direction, a, b, c;
  Range range;
};

/// A TriangleHit whose numbers are bits of the format asked for.
struct TriangleBits {
  TriangleKind kind = TriangleKind::miss;
  Facing facing = Facing::none;
  std::uint64_t t = 0, t_end = 0, u = 0, v = 0;
};

enum class Wanted { decision, numbers };

/// The feature that holds a point by which of its barycentric weights are zero; at most two are.
TriangleKind feature(bool a_is_zero, bool b_is_zero, bool c_is_zero) noexcept {
  if (a_is_zero) return b_is_zero ? TriangleKind::vertex_c : c_is_zero ? TriangleKind::vertex_b : TriangleKind::edge_bc;
  if (b_is_zero) return c_is_zero ? TriangleKind::vertex_a : TriangleKind::edge_ca;
  return c_is_zero ? TriangleKind::edge_ab : TriangleKind::face;
}

template <int K>
TriangleBits answer_interval(const LineInterval<2 * K>& interval, TriangleKind kind, const TriangleInput& in,
                             const Format& format, Wanted wanted) noexcept {
  if (!interval) return {};
  const IntervalBits bits = clip(interval->first, interval->second, in.range, format, wanted == Wanted::numbers);
  if (bits.empty) return {};
  return {kind, Facing::none, bits.first, bits.last, 0, 0};
}

/// With P, Q, R the corners relative to the origin, det = d . n; the weights of the corners b and c are b/det and c/det, that
/// of a is the rest, and t = P . n / det.
template <int K>
TriangleBits answer(const TriangleInput& in, int position_unit, int direction_unit, const Format& format,
                    Wanted wanted) noexcept {
  const IntegerVec3<K> e = integer_vec3<K>(in.origin, position_unit);
  const IntegerVec3<K> p = integer_vec3<K>(in.a, position_unit) - e;
  const IntegerVec3<K> q = integer_vec3<K>(in.b, position_unit) - e;
  const IntegerVec3<K> r = integer_vec3<K>(in.c, position_unit) - e;
  const IntegerVec3<K> d = integer_vec3<K>(in.direction, direction_unit);
  const IntegerVec3<2 * K> n = cross(q - p, r - p);
  const int scale = position_unit - direction_unit;

  if (is_zero(n)) {
    const auto [from, to] = hull_ends(p, q, r);
    return answer_interval<K>(meet_segment(d, *from, *to, scale), TriangleKind::degenerate, in, format, wanted);
  }
  const Integer<3 *K> determinant = dot(n, d), distance = dot(n, p);
  const int facing = determinant.sign();
  if (facing == 0) {
    if (!distance.is_zero()) return {};
    return answer_interval<K>(clip_by_edges(d, p, q, r, n, scale), TriangleKind::coplanar, in, format, wanted);
  }

  TriangleBits out;
  out.facing = facing < 0 ? Facing::front : Facing::back;
  const bool flipped = facing < 0;
  // d . (R x P) and d . (P x Q), by s = d x P.
  const IntegerVec3<2 * K> s = cross(d, p);
  const Integer<3 * K> whole = negate_if(flipped, determinant);
  const Integer<3 *K> b = negate_if(!flipped, dot(s, r)), c = negate_if(flipped, dot(s, q));
  if (b.is_negative() || c.is_negative()) return out;
  const Integer<3 * K> a = whole - b - c;
  if (a.is_negative()) return out;
  const Quotient<3 * K> t(distance, determinant, scale);
  if (!in.range.contains(t)) return out;
  out.kind = feature(a.is_zero(), b.is_zero(), c.is_zero());
  if (wanted == Wanted::decision) return out;
  out.t = out.t_end = round_to_bits(t, format);
  out.u = round_to_bits(Quotient<3 * K>(b, whole, 0), format);
  out.v = round_to_bits(Quotient<3 * K>(c, whole, 0), format);
  return out;
}

TriangleBits answer(const TriangleInput& in, const Format& format, Wanted wanted) noexcept {
  Extent positions, directions;
  for (const DyadicVec3* v : {&in.origin, &in.a, &in.b, &in.c}) positions.include(*v);
  directions.include(in.direction);
  const int width = std::max(positions.width(), directions.width());
  return with_tier(width, [&]<int K>() { return answer<K>(in, positions.low, directions.low, format, wanted); });
}

template <Real T>
TriangleInput input(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  using numeric::dyadic;
  return {dyadic(ray.origin), dyadic(ray.direction), dyadic(triangle.a),
          dyadic(triangle.b), dyadic(triangle.c),    range(ray.t_min, ray.t_max)};
}

}  // namespace

template <Real T>
TriangleHit<T> intersect(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  TriangleHit<T> hit;
  hit.status = status_of(ray, triangle);
  if (hit.status != Status::ok) {
    hit.kind = TriangleKind::invalid;
    return hit;
  }
  const TriangleBits bits = answer(input(ray, triangle), numeric::format_of<T>, Wanted::numbers);
  const auto number = [](std::uint64_t b) { return std::bit_cast<T>(static_cast<numeric::Bits<T>>(b)); };
  return {Status::ok, bits.kind, bits.facing, number(bits.t), number(bits.t_end), number(bits.u), number(bits.v)};
}

template <Real T>
TriangleDecision decide(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  const TriangleBits bits = answer(input(ray, triangle), numeric::format_of<T>, Wanted::decision);
  return {bits.kind, bits.facing};
}

template <Real T>
bool hits(const Ray<T>& ray, const Triangle<T>& triangle) noexcept {
  return status_of(ray, triangle) == Status::ok && decide(ray, triangle).kind != TriangleKind::miss;
}

template TriangleHit<float> intersect(const Ray<float>&, const Triangle<float>&) noexcept;
template TriangleHit<double> intersect(const Ray<double>&, const Triangle<double>&) noexcept;
template TriangleDecision decide(const Ray<float>&, const Triangle<float>&) noexcept;
template TriangleDecision decide(const Ray<double>&, const Triangle<double>&) noexcept;
template bool hits(const Ray<float>&, const Triangle<float>&) noexcept;
template bool hits(const Ray<double>&, const Triangle<double>&) noexcept;

}  // namespace graze::exact
