// Ray and sphere by the quadratic solver of Goualard, "The ins and outs of solving quadratic equations with floating-point
// arithmetic", 2023 (after Sterbenz, "Floating-point computation", 1974): the exponents of a and b are divided out, so that
// nothing under- or overflows before the roots do; Kahan's discriminant, with the rounding errors of both products ("On the
// cost of floating-point computation without extra-precise arithmetic", 2004); roots without cancellation. For given
// coefficients its roots are right within a few ulps. Fails because the coefficients of a sphere are rounded before it sees
// them: near a tangent the computed discriminant is exact, but of another quadratic; far from a small sphere c has lost the
// radius. Coefficients that are no numbers are a miss.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "fuzz/case.hpp"
#include "fuzz/deviations.hpp"
#include "graze/textbook/sphere.hpp"

namespace graze::fuzz::goualard_quadratic {

/// b^2 - 4 a c, right but for two ulps unless it under- or overflows.
template <Real T>
T kahan_discriminant(T a, T b, T c) {
  const T p = b * b, q = 4 * a * c;
  if (3 * std::abs(p - q) >= p + q) return p - q;
  const T dp = std::fma(b, b, -p), dq = std::fma(4 * a, c, -q);
  return (p - q) + (dp - dq);
}

/// No root, one that is double or of a linear equation, or two, ascending.
template <Real T>
struct Solution {
  int count = 0;
  T first{}, second{};
};

template <Real T>
Solution<T> two(T s, T t) {
  return s <= t ? Solution<T>{2, s, t} : Solution<T>{2, t, s};
}

/// a t^2 + b t + c = 0 for finite a, b, c.
template <Real T>
Solution<T> solve(T a, T b, T c) {
  if (a == 0) return b == 0 ? Solution<T>{} : Solution<T>{1, -c / b, {}};
  if (c == 0) return b == 0 ? Solution<T>{1, T(0), {}} : two(T(0), -b / a);
  // a = a1 2^ea with 1 <= |a1| < 2, and likewise b and c.
  const int ea = std::ilogb(a), ec = std::ilogb(c);
  const T a1 = std::scalbn(a, -ea), c1 = std::scalbn(c, -ec);
  if (b == 0) {
    if ((a > 0) == (c > 0)) return {};
    // The odd bit of the exponent goes under the root.
    const int e = ec - ea, odd = e & 1;
    const T t = std::scalbn(std::sqrt(std::scalbn(-c1 / a1, odd)), (e - odd) / 2);
    return {2, -t, t};
  }
  // With t = 2^k s: a1 s^2 + b1 s + c1 2^l = 0.
  const int eb = std::ilogb(b), k = eb - ea, l = ea + ec - 2 * eb;
  const T b1 = std::scalbn(b, -eb);
  constexpr int wide = std::numeric_limits<T>::max_exponent - 4;
  if (l <= -wide) return two(std::scalbn(-b1 / a1, k), std::scalbn(-c1 / b1, ec - eb));  // 4 a c is nothing beside b^2
  if (l >= wide) {                                                                       // b^2 is nothing beside 4 a c
    if ((a > 0) == (c > 0)) return {};
    return solve(a, T(0), c);
  }
  const T c2 = std::scalbn(c1, l);
  const T discriminant = kahan_discriminant(a1, b1, c2);
  if (discriminant < 0) return {};
  if (discriminant == 0) return {1, std::scalbn(-b1 / (2 * a1), k), {}};
  const T root = std::sqrt(discriminant);
  const T q = b1 < 0 ? -b1 + root : -b1 - root;
  return two(std::scalbn(q / (2 * a1), k), std::scalbn((2 * c2) / q, k));
}

struct Formula {
  static constexpr std::string_view name = "goualard-quadratic";
  static constexpr std::string_view about =
      "scaled coefficients, Kahan's discriminant; Goualard, The ins and outs of solving quadratic equations with "
      "floating-point "
      "arithmetic, 2023";
  static constexpr Deviations deviations{{Deviation::invalid_unhandled}};

  template <Real T>
  static SphereHit<T> answer(const RaySphere<T>& query) {
    const textbook::Quadratic<T> q = textbook::quadratic(query.ray, query.sphere);
    SphereHit<T> hit;
    hit.origin = q.c < 0 ? OriginSide::inside : q.c > 0 ? OriginSide::outside : OriginSide::on;
    if (!std::isfinite(q.a) || !std::isfinite(q.b) || !std::isfinite(q.c)) return hit;
    const Solution<T> solution = solve(q.a, q.b, q.c);
    if (solution.count == 0) return hit;
    if (solution.count == 1) return textbook::detail::hit_of_double_root(query.ray, hit.origin, solution.first);
    return textbook::detail::hit_of_roots(query.ray, hit.origin, textbook::Roots<T>{solution.first, solution.second});
  }
};

}  // namespace graze::fuzz::goualard_quadratic
