// How ends of ranges are drawn, and compared with marks.
#include "fuzz/families/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fuzz/families/float_bits.hpp"

namespace graze::fuzz::construct {

namespace {

/// A double, times 2^exponent, in the format; the largest number or zero where it leaves the range.
template <Real T>
T converted(double x, int exponent) {
  const Parts at = parts(x);
  bool exact = true;
  return scaled<T>(at.mantissa, at.exponent + exponent, exact);
}

struct DoubleVec {
  double x, y, z;
};
template <Real T>
DoubleVec widened(const Vec3<T>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
DoubleVec minus(const DoubleVec& p, const DoubleVec& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
double dot(const DoubleVec& p, const DoubleVec& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
DoubleVec cross(const DoubleVec& p, const DoubleVec& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

template <Real T>
void add_guess(Guesses<T>& all, double t) {
  if (is_finite(t)) all.at[static_cast<std::size_t>(all.count++)] = converted<T>(t, 0);
}

/// A number of the format of any modest size.
template <Real T>
T random_end(Random& random) {
  const int exponent = random.between(-digits<T> - 8, 8);
  const Int mantissa = choose_integer(random, digits<T>);
  bool exact = true;
  return scaled<T>(mantissa, exponent, exact);
}

}  // namespace

template <Real T>
Guesses<T> guesses(const Marks& marks, int exponent) {
  Guesses<T> all;
  for (int i = 0; i < marks.count; ++i) {
    const Mark& mark = marks.at[static_cast<std::size_t>(i)];
    const double t = static_cast<double>(mark.num) / static_cast<double>(mark.den);
    all.at[static_cast<std::size_t>(all.count++)] = converted<T>(t, exponent);
  }
  return all;
}

template <Real T>
Guesses<T> guesses(const RaySphere<T>& input) {
  const DoubleVec d = widened(input.ray.direction);
  const DoubleVec l = minus(widened(input.sphere.center), widened(input.ray.origin));
  const double r = static_cast<double>(input.sphere.radius);
  const double a = dot(d, d);
  const double b = dot(d, l);
  const DoubleVec across = cross(d, l);
  const double discriminant = a * r * r - dot(across, across);
  const double root = discriminant > 0 ? std::sqrt(discriminant) : 0.0;
  Guesses<T> all;
  add_guess(all, (b - root) / a);
  add_guess(all, (b + root) / a);
  return all;
}

template <Real T>
Guesses<T> guesses(const RayTriangle<T>& input) {
  const DoubleVec d = widened(input.ray.direction);
  const DoubleVec a = widened(input.triangle.a);
  const DoubleVec normal = cross(minus(widened(input.triangle.b), a), minus(widened(input.triangle.c), a));
  Guesses<T> all;
  add_guess(all, dot(normal, minus(a, widened(input.ray.origin))) / dot(normal, d));
  return all;
}

template <Real T>
void choose_bounds(Ray<T>& ray, Guesses<T> near, Random& random) {
  constexpr T most = std::numeric_limits<T>::max();
  if (near.count == 0) near = {{random_end<T>(random), T(0)}, 1};
  if (near.count == 1) near.at[1] = near.at[0];
  if (random.one_in(2)) std::swap(near.at[0], near.at[1]);
  const int first_off = random.between(-2, 2);
  const int second_off = random.between(-2, 2);
  const T first = step(near.at[0], first_off / 2);
  const T second = step(near.at[1], second_off / 2);
  const T between = first / 2 + second / 2;
  T low = T(0);
  T high = std::numeric_limits<T>::infinity();
  switch (random.below(8)) {
    case 0:
      low = first;
      break;
    case 1:
      low = first > T(0) ? T(0) : -most;
      high = first;
      break;
    case 2:
      low = high = first;
      break;
    case 3:
      low = first;
      high = second;
      break;
    case 4:
      low = between;
      break;
    case 5:
      low = -most;
      high = between;
      break;
    case 6:
      low = random_end<T>(random);
      high = random.one_in(2) ? first : high;
      break;
    default:
      low = step(first, -1);
      high = step(first, 1);
      break;
  }
  ray.t_min = std::min(low, high);
  ray.t_max = std::max(low, high);
}

template <Real T>
int compare(T x, const Mark& mark, int exponent) {
  const Parts at = parts(x);
  Int left = at.mantissa * mark.den;
  Int right = mark.num;
  const int sign = sign_of(left);
  if (sign != sign_of(right)) return sign > sign_of(right) ? 1 : -1;
  if (sign == 0) return 0;
  const int shift = at.exponent - exponent;  // compare left * 2^shift with right
  const int longer = bit_length(left) + shift - bit_length(right);
  if (longer != 0) return longer > 0 ? sign : -sign;
  (shift > 0 ? left : right) *= power_of_two(std::abs(shift));
  return sign_of(left - right);
}

template Guesses<float> guesses<float>(const Marks&, int);
template Guesses<double> guesses<double>(const Marks&, int);
template Guesses<float> guesses<float>(const RaySphere<float>&);
template Guesses<double> guesses<double>(const RaySphere<double>&);
template Guesses<float> guesses<float>(const RayTriangle<float>&);
template Guesses<double> guesses<double>(const RayTriangle<double>&);
template void choose_bounds<float>(Ray<float>&, Guesses<float>, Random&);
template void choose_bounds<double>(Ray<double>&, Guesses<double>, Random&);
template int compare<float>(float, const Mark&, int);
template int compare<double>(double, const Mark&, int);

}  // namespace graze::fuzz::construct
