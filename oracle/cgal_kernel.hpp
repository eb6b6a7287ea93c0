// What the CGAL oracle computes with: CGAL's Cartesian kernel over CGAL's own multi-precision floats. Floating-point inputs
// enter as they are, nothing is filtered, and no limb passes through GMP, so the two oracles share no arithmetic.
#pragma once

#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/intersections.h>

#include <stdexcept>

#include "graze/types.hpp"

#if defined(CGAL_NDEBUG) || defined(NDEBUG)
#error "The oracle wants CGAL with its assertions: compile this file with -UNDEBUG and CGAL_DEBUG"
#endif

namespace graze::oracle::cgal {

using Number = CGAL::MP_Float;                  ///< a ring: exact sums and products
using Field = CGAL::Quotient<Number>;           ///< exact quotients
using Kernel = CGAL::Simple_cartesian<Number>;  ///< predicates and ring constructions; anything that divides does not compile

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Line = Kernel::Line_3;

template <Real T>
[[nodiscard]] Point point(const Vec3<T>& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

template <Real T>
[[nodiscard]] Vector vector(const Vec3<T>& v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}

/// Two ways that CGAL offers to the same decision must agree; if they do not, there is no truth to tell.
inline void confirm(bool agreed, const char* what) {
  if (!agreed) throw std::logic_error(what);
}

}  // namespace graze::oracle::cgal
