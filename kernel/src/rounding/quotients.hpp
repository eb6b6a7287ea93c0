// t, u and v of a hit inside the face, as pairs with their errors, and the rounding of them.
#pragma once

#include "graze/triangle.hpp"
#include "numeric/double_double.hpp"
#include "rounding/candidate.hpp"

namespace graze::rounding {

using numeric::Lanes;
using predicates::TriangleTerms;

/// Of a face's determinants in double: bounds of their errors, as in TriangleTerms, and which side the ray comes from.
struct FaceBounds {
  double error, distance_error;
  bool is_front;
};
[[nodiscard]] inline FaceBounds bounds_of(const TriangleTerms<double>& terms) noexcept {
  return {terms.error, terms.distance_error, terms.is_front};
}

/// t, u, v as hi + lo, each within its error.
struct Quotients {
  Lanes hi, lo;
  double t_error, u_error, v_error;
  bool are_bounded;
};

/// The error of n / d: (n_error + |q| d_error) / |d| to first order, and `division` |q| for the division itself. `relative`
/// scales the errors of the terms to those of the determinants used.
[[nodiscard]] inline Quotients with_errors(const Lanes& hi, const Lanes& lo, double determinant, const FaceBounds& bounds,
                                           double relative, double division) noexcept {
  using numeric::magnitude;
  const double size = magnitude(determinant), scale = (1 + second_order) * relative / size;
  const auto error = [&](double q, double n_error) {
    return (n_error + magnitude(q) * bounds.error) * scale + magnitude(q) * division;
  };
  return {hi,
          lo,
          error(hi[0], bounds.distance_error),
          error(hi[1], bounds.error),
          error(hi[2], bounds.error),
          size > certainty * relative * bounds.error};
}

/// `relative` for determinants in double-double.
inline constexpr double pair_relative = pair_determinant_error / (predicates::triangle_error * numeric::unit);

/// Whether t, u and v are rounded for certain, and then the hit.
template <Real T>
[[nodiscard]] inline bool round_certainly(const Quotients& q, const FaceBounds& bounds, TriangleHit<T>& hit) noexcept {
  const bool is_t_certain = rounds_certainly(q.hi[0], q.lo[0], q.t_error, hit.t);
  const bool is_u_certain = rounds_certainly(q.hi[1], q.lo[1], q.u_error, hit.u);
  const bool is_v_certain = rounds_certainly(q.hi[2], q.lo[2], q.v_error, hit.v);
  hit.kind = TriangleKind::face;
  hit.facing = bounds.is_front ? Facing::front : Facing::back;
  hit.t_end = hit.t;
  // One branch for all: & and not &&.
  return q.are_bounded & is_t_certain & is_u_certain & is_v_certain;
}

}  // namespace graze::rounding
