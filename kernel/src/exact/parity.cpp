#include "exact/parity.hpp"

#include "exact/flat.hpp"

namespace graze::exact {
namespace {

using numeric::dyadic;

/// Calls f with the corners relative to the point, in integers.
template <Real T, class F>
bool with_corners(const Vec3<T>& point, const Triangle<T>& triangle, F f) noexcept {
  const DyadicVec3 o = dyadic(point), a = dyadic(triangle.a), b = dyadic(triangle.b), c = dyadic(triangle.c);
  Extent extent;
  for (const DyadicVec3* v : {&o, &a, &b, &c}) extent.include(*v);
  const int unit = extent.low;
  return with_tier(extent.width(), [&]<int K>() {
    const IntegerVec3<K> e = integer_vec3<K>(o, unit);
    return f.template operator()<K>(integer_vec3<K>(a, unit) - e, integer_vec3<K>(b, unit) - e, integer_vec3<K>(c, unit) - e);
  });
}

/// Whether 0 lies on the segment uv.
template <int K>
bool is_on_segment(const IntegerVec3<K>& u, const IntegerVec3<K>& v) noexcept {
  return is_zero(cross(u, v)) && dot(u, v).sign() <= 0;
}

/// On which side of uv, seen along x, the point (e, e^2) lies: the sign of u x v + e (u.z - v.z) + e^2 (v.y - u.y).
template <int K>
int perturbed_side(const IntegerVec3<K>& u, const IntegerVec3<K>& v) noexcept {
  const int side = (u.y * v.z - u.z * v.y).sign();
  if (side != 0) return side;
  const int z = compare(u.z, v.z);
  return z != 0 ? z : compare(v.y, u.y);
}

}  // namespace

template <Real T>
bool is_on(const Vec3<T>& point, const Triangle<T>& triangle) noexcept {
  return with_corners(point, triangle, []<int K>(const IntegerVec3<K>& p, const IntegerVec3<K>& q, const IntegerVec3<K>& r) {
    const IntegerVec3<2 * K> n = cross(q - p, r - p);
    if (is_zero(n)) {
      const auto [from, to] = hull_ends(p, q, r);
      return is_on_segment(*from, *to);
    }
    if (!dot(n, p).is_zero()) return false;
    const int axis = nonzero_axis(n), inner = component(n, axis).sign();
    for (const auto& [u, v] : {std::pair{&p, &q}, std::pair{&q, &r}, std::pair{&r, &p}}) {
      if (component(cross(*u, *v), axis).sign() * inner < 0) return false;
    }
    return true;
  });
}

template <Real T>
bool is_crossed(const Vec3<T>& point, const Triangle<T>& triangle) noexcept {
  return with_corners(point, triangle, []<int K>(const IntegerVec3<K>& p, const IntegerVec3<K>& q, const IntegerVec3<K>& r) {
    const IntegerVec3<2 * K> n = cross(q - p, r - p);
    const int inner = n.x.sign();
    if (inner == 0) return false;
    if (perturbed_side(p, q) != inner || perturbed_side(q, r) != inner || perturbed_side(r, p) != inner) return false;
    // The crossing is at t = P . n / n.x, which is not 0: else the point, the limit of p', were on the triangle.
    return dot(n, p).sign() == inner;
  });
}

template bool is_on(const Vec3<float>&, const Triangle<float>&) noexcept;
template bool is_on(const Vec3<double>&, const Triangle<double>&) noexcept;
template bool is_crossed(const Vec3<float>&, const Triangle<float>&) noexcept;
template bool is_crossed(const Vec3<double>&, const Triangle<double>&) noexcept;

}  // namespace graze::exact
