// The first value of a hit, exact: the ray's start, a quotient or a root, all of one ray and in one pair of units.
#pragma once

#include <optional>

#include "exact/flat.hpp"
#include "exact/quotient.hpp"
#include "exact/range.hpp"
#include "exact/root.hpp"
#include "exact/scaled.hpp"

namespace graze::exact {

/// The ray in integers.
template <int K>
struct IntegerRay {
  IntegerVec3<K> origin, direction;
  int position_unit;
  int scale;  ///< t is a value of these integers times 2^scale
  Range range;
};

/// With K-limb coordinates a triangle's t is a quotient of 3 K limbs, a tangent's or an interval's end of 2 K.
template <int K>
struct FirstValue {
  enum class Form { start, quotient, root } form = Form::start;  ///< start: t_min itself
  std::optional<Quotient<3 * K>> quotient;
  std::optional<Quadratic<K>> quadratic;
  bool is_second = false;  ///< which root

  [[nodiscard]] QuadraticRoot<K> root() const noexcept { return {*quadratic, is_second}; }
};

template <int K>
[[nodiscard]] inline Quotient<3 * K> widened(const Quotient<2 * K>& q) noexcept {
  return {numeric::extend<3 * K>(q.numerator()), numeric::extend<3 * K>(q.denominator()), q.scale()};
}

/// The least t of the common part that is not before the ray's start. The ray meets it.
template <int K>
inline void set_interval(FirstValue<K>& out, const LineInterval<2 * K>& interval, const Range& range) noexcept {
  if (!interval || range.starts_after(interval->first)) return;
  out.form = FirstValue<K>::Form::quotient;
  out.quotient.emplace(widened<K>(interval->first));
}

/// t = P . n / d . n, with corners relative to the origin. The ray meets the triangle.
template <int K>
inline void set_first(FirstValue<K>& out, const IntegerRay<K>& ray, const numeric::DyadicVec3 (&corners)[3]) noexcept {
  const IntegerVec3<K>&e = ray.origin, &d = ray.direction;
  const IntegerVec3<K> p = integer_vec3<K>(corners[0], ray.position_unit) - e;
  const IntegerVec3<K> q = integer_vec3<K>(corners[1], ray.position_unit) - e;
  const IntegerVec3<K> r = integer_vec3<K>(corners[2], ray.position_unit) - e;
  const IntegerVec3<2 * K> n = cross(q - p, r - p);
  if (is_zero(n)) {
    const auto [from, to] = hull_ends(p, q, r);
    return set_interval(out, meet_segment(d, *from, *to, ray.scale), ray.range);
  }
  const Integer<3 * K> determinant = dot(n, d);
  if (determinant.is_zero()) return set_interval(out, clip_by_edges(d, p, q, r, n, ray.scale), ray.range);
  out.form = FirstValue<K>::Form::quotient;
  out.quotient.emplace(dot(n, p), determinant, ray.scale);
}

/// The first root in the range. The ray meets the sphere.
template <int K>
inline void set_first(FirstValue<K>& out, const IntegerRay<K>& ray, const numeric::DyadicVec3& center,
                      const Dyadic& radius) noexcept {
  const IntegerVec3<K> l = integer_vec3<K>(center, ray.position_unit) - ray.origin;
  const Integer<K> r = numeric::integer<K>(radius, ray.position_unit);
  const Integer<2 *K> a = dot(ray.direction, ray.direction), b = dot(ray.direction, l), c = dot(l, l) - r * r;
  const Integer<4 * K> discriminant = b * b - a * c;
  if (discriminant.is_zero()) {
    out.form = FirstValue<K>::Form::quotient;
    out.quotient.emplace(widened<K>({b, a, ray.scale}));
    return;
  }
  out.form = FirstValue<K>::Form::root;
  out.quadratic.emplace(Quadratic<K>{a, b, c, discriminant, ray.scale});
  out.is_second = !ray.range.contains(QuadraticRoot<K>(*out.quadratic, false));
}

/// The sign of x + s sqrt(y), from the signs of x and s, and of x^2 - y where those differ.
template <class CompareSquares>
[[nodiscard]] inline int sign_of_sum(int x, int s, CompareSquares compare_squares) noexcept {
  if (x == 0 || s == 0 || x == s) return x != 0 ? x : s;
  return x * compare_squares();
}

/// (B1 -+ sqrt(D1)) / A against (B2 -+ sqrt(D2)) / A, the ray's A being common: the sign of E + P with E = B1 - B2 and P =
/// s1 sqrt(D1) - s2 sqrt(D2). Where they have opposite signs, E^2 - P^2 = (E^2 - D1 - D2) + 2 s1 s2 sqrt(D1 D2) decides. With
/// |L| < 2^(w+1), |d| < 2^w a component: |E| < 2^(2w+4), |D| < 2^(4w+7), so E^2 - D1 - D2 < 2^(4w+9) <= 2^(256K-7) and its
/// square and 4 D1 D2 stay below 2^(512K-14).
template <int K>
[[nodiscard]] inline int compare_roots(const FirstValue<K>& one, const FirstValue<K>& other) noexcept {
  const Quadratic<K>&q1 = *one.quadratic, &q2 = *other.quadratic;
  const int s1 = one.is_second ? 1 : -1, s2 = other.is_second ? 1 : -1;
  const Integer<2 * K> e = q1.b - q2.b;
  const int p = s1 != s2 ? s1 : s1 * compare(q1.discriminant, q2.discriminant);
  return sign_of_sum(e.sign(), p, [&] {
    const Integer<4 * K> w = e * e - q1.discriminant - q2.discriminant;
    return sign_of_sum(w.sign(), s1 * s2, [&] { return compare(w * w, shift_left(q1.discriminant * q2.discriminant, 2)); });
  });
}

/// (B + s sqrt(D)) / A against n / q with q > 0: the sign of (B q - A n) + s q sqrt(D). |B q|, |A n| < 2^(128K-2 + 192K-6), so
/// their difference fits 5 K limbs and its square, like q^2 D, 10 K.
template <int K>
[[nodiscard]] inline int compare_root_with_quotient(const FirstValue<K>& root, const Quotient<3 * K>& t) noexcept {
  const Quadratic<K>& k = *root.quadratic;
  const Integer<5 * K> x = k.b * t.denominator() - k.a * t.numerator();
  return sign_of_sum(x.sign(), root.is_second ? 1 : -1,
                     [&] { return compare(x * x, (t.denominator() * t.denominator()) * k.discriminant); });
}

template <int K>
[[nodiscard]] inline int compare(const FirstValue<K>& one, const FirstValue<K>& other, const Range& range) noexcept {
  using Form = typename FirstValue<K>::Form;
  if (one.form == Form::start) {
    if (other.form == Form::start) return 0;
    return other.form == Form::root ? -numeric::compare(other.root(), range.t_min)
                                    : -numeric::compare(*other.quotient, range.t_min);
  }
  if (other.form == Form::start) return -compare(other, one, range);
  if (one.form == Form::quotient) {
    return other.form == Form::quotient ? one.quotient->compare_with(*other.quotient)
                                        : -compare_root_with_quotient(other, *one.quotient);
  }
  return other.form == Form::root ? compare_roots(one, other) : compare_root_with_quotient(one, *other.quotient);
}

}  // namespace graze::exact
