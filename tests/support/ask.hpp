// The kernel asked about a ray, its answer held against one made by hand.
#pragma once

#include "fuzz/same_bits.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "tests/catch.hpp"
#include "tests/support/answers.hpp"

namespace graze::test {

/// Checks the answer bit by bit, and that `hits` tells the same.
template <Real T, template <class> class Shape, template <class> class Hit>
void check_answer(const Ray<T>& ray, const Shape<T>& shape, const Hit<T>& expected) {
  const Hit<T> found = intersect(ray, shape);
  CAPTURE(found, expected);
  CHECK(fuzz::same_bits(found, expected));
  using Kind = decltype(expected.kind);
  CHECK(hits(ray, shape) == (expected.kind != Kind::miss && expected.kind != Kind::invalid));
}

}  // namespace graze::test
