// The truth: one interface, two implementations that share no arithmetic, one on CGAL's exact kernels, one on GMP.
#pragma once

#include <gmpxx.h>

#include <string_view>

#include "graze/answer.hpp"
#include "graze/types.hpp"

namespace graze::oracle {

/// The exact real number rational + root_sign * sqrt(radicand), with root_sign in {-1, 0, 1} and radicand >= 0.
struct Exact {
  mpq_class rational;
  mpq_class radicand;
  int root_sign = 0;
};

/// The answer of the contract with the exact values behind its rounded numbers; t[i] is meaningful for i < hit.count().
template <Real T>
struct SphereTruth {
  SphereHit<T> hit;
  Exact t[2];
};

/// `t`, `u`, `v` are meaningful for one common point, `t` and `t_end` for an interval.
template <Real T>
struct TriangleTruth {
  TriangleHit<T> hit;
  Exact t, t_end, u, v;
};

/// Answers every input by the contract, invalid ones included. Stateless; safe to share between threads.
/// `answer` gives the correctly rounded answer alone and is the cheaper call; `truth` adds the exact values.
class Oracle {
 public:
  virtual ~Oracle() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;

  [[nodiscard]] virtual SphereHit<float> answer(const Ray<float>&, const Sphere<float>&) const = 0;
  [[nodiscard]] virtual SphereHit<double> answer(const Ray<double>&, const Sphere<double>&) const = 0;
  [[nodiscard]] virtual TriangleHit<float> answer(const Ray<float>&, const Triangle<float>&) const = 0;
  [[nodiscard]] virtual TriangleHit<double> answer(const Ray<double>&, const Triangle<double>&) const = 0;

  [[nodiscard]] virtual SphereTruth<float> truth(const Ray<float>&, const Sphere<float>&) const = 0;
  [[nodiscard]] virtual SphereTruth<double> truth(const Ray<double>&, const Sphere<double>&) const = 0;
  [[nodiscard]] virtual TriangleTruth<float> truth(const Ray<float>&, const Triangle<float>&) const = 0;
  [[nodiscard]] virtual TriangleTruth<double> truth(const Ray<double>&, const Triangle<double>&) const = 0;

  [[nodiscard]] virtual Side side(const Vec2<float>&, const Line<float>&) const = 0;
  [[nodiscard]] virtual Side side(const Vec2<double>&, const Line<double>&) const = 0;
  [[nodiscard]] virtual Side side(const Vec3<float>&, const Plane<float>&) const = 0;
  [[nodiscard]] virtual Side side(const Vec3<double>&, const Plane<double>&) const = 0;
  [[nodiscard]] virtual Side side(const Vec3<float>&, const Sphere<float>&) const = 0;
  [[nodiscard]] virtual Side side(const Vec3<double>&, const Sphere<double>&) const = 0;
};

/// GMP integers and rationals alone; knows nothing of CGAL. Fast: the certifier's workhorse.
[[nodiscard]] const Oracle& gmp_oracle();

/// CGAL's predicates over its own exact numbers (MP_Float) decide, quotients and square roots of these (Quotient,
/// Sqrt_extension) are compared to round. Slow. Throws std::logic_error where two parts of CGAL contradict one another.
[[nodiscard]] const Oracle& cgal_oracle();

/// |x - value| in units of the last place of the format T at `value` (subnormal spacing below the normal range; at overflow
/// the spacing of the largest numbers). Correctly rounded, so exact to a relative 2^-50 unless it is a subnormal number.
/// Infinity where x is NaN, or infinite and the correctly rounded value is not; 0 where both are the same infinity.
template <Real T>
[[nodiscard]] double error_in_ulps(const Exact& value, T x);

}  // namespace graze::oracle
