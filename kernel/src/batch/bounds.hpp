// The error units of lanes that compute in their inputs' own format. As numeric/filter.hpp says of double: one operation errs
// by at most `unit` relative, whatever the rounding mode, and one that underflows, or reads an input as zero, by `flushed`
// more.
//
// Sizes are asked to be so that nothing overflows: with directed rounding an overflow may give the largest finite number, and
// no infinity tells of it.
#pragma once

#include "graze/types.hpp"

namespace graze::batch {

template <Real T>
struct Bounds;

template <>
struct Bounds<float> {
  static constexpr float unit = 0x1p-23F, flushed = 0x1p-126F;
  /// Magnitudes of vectors, and of a range's bounds.
  static constexpr float low = 0x1p-24F, high = 0x1p30F;
  /// Of sums of squares of positions.
  static constexpr float most_squares = 0x1p64F;
};

template <>
struct Bounds<double> {
  static constexpr double unit = 0x1p-52, flushed = 0x1p-1022;
  static constexpr double low = 0x1p-200, high = 0x1p200;
  static constexpr double most_squares = 0x1p400;
};

/// Of the lanes' own forms, in units of the sums of magnitudes that each file names. Proved in kernel/proofs/batch_*.g.
inline constexpr float determinant_error = 9;           ///< triangles-inl.hpp: a determinant
inline constexpr float combination_share = 1.25;        ///< the same: of the bounds' sum, what a sum of determinants takes
inline constexpr float sphere_c_error = 8;              ///< spheres-inl.hpp: C
inline constexpr float sphere_discriminant_error = 32;  ///< spheres-inl.hpp: D
inline constexpr float sphere_place_error = 8;          ///< spheres-inl.hpp: a number against the roots
inline constexpr float unit_sphere_error = 16;          ///< unit_spheres-inl.hpp: C and D, of L.L, in rounding to nearest
inline constexpr float sheared_error = 16;              ///< sheared_triangles-inl.hpp: U, V, W and, times a length, T

}  // namespace graze::batch
