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

}  // namespace graze::fuzz
