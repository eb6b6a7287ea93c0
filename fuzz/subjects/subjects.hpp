// The built-in subjects, each in a file of its own. graze_subject is alone in its object file, so a program that defines the
// function itself, over a mutated kernel, is linked with that one in its place.
#pragma once

#include "fuzz/subject.hpp"

namespace graze::fuzz {

/// The kernel: all queries.
[[nodiscard]] const Subject& graze_subject();

/// The quadratic as it is taught, and the implicit forms by the computed sign of f: spheres, lines, planes.
[[nodiscard]] const Subject& textbook_naive_subject();

/// The quadratic without cancellation, sgn(0) = 0: ray and sphere.
[[nodiscard]] const Subject& textbook_stable_subject();

/// The quadratic without cancellation, sgn(0) = 1: ray and sphere.
[[nodiscard]] const Subject& textbook_repaired_subject();

/// Cramer's rule: ray and triangle.
[[nodiscard]] const Subject& cramer_subject();

/// Moeller and Trumbore: ray and triangle.
[[nodiscard]] const Subject& moller_trumbore_subject();

/// Woop, Benthin and Wald's sheared edge functions: ray and triangle.
[[nodiscard]] const Subject& woop_watertight_subject();

/// Haines et al., the discriminant from the perpendicular remainder: ray and sphere.
[[nodiscard]] const Subject& haines_sphere_subject();

/// Goualard's solver of the quadratic: ray and sphere.
[[nodiscard]] const Subject& goualard_quadratic_subject();

/// Intervals as in pbrt, a doubtful hit is a miss: ray and sphere.
[[nodiscard]] const Subject& pbrt_interval_subject();

/// CGAL's exact predicates with inexact constructions: ray and triangle.
[[nodiscard]] const Subject& cgal_epick_subject();

/// Embree with its default scene flags: ray and triangle, ray and sphere, in float. Only where Embree was found.
[[nodiscard]] const Subject& embree_subject();

/// Embree with its robust scene flag: as above.
[[nodiscard]] const Subject& embree_robust_subject();

}  // namespace graze::fuzz
