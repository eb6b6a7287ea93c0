// Every length around the widths of vectors, words and runs, at every alignment, by every instruction set.
#include "fuzz/batch_check.hpp"
#include "tests/batch/targets.hpp"
#include "tests/catch.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using fuzz::Batch;
using fuzz::BatchForm;

/// Hits and misses in a pattern of no period that a vector has.
template <Real T>
Batch<T, Triangle> batch_of_triangles(BatchForm form, std::size_t n, std::size_t offset) {
  Batch<T, Triangle> batch{form, fuzz::FloatMode::nearest, offset, {}, {}};
  const Ray<T> ray{{T(0.25), T(0.25), -1}, {0, 0, 1}};
  for (std::size_t i = 0; i < n; ++i) {
    // Misses, hits, hits on an edge, and a plane that the ray runs in.
    const T shift = T(i % 7 % 3), height = T(i % 11);
    Triangle<T> triangle{{shift, 0, height}, {shift + 1, 0, height}, {shift, 1, height}};
    if (i % 13 == 5) triangle = {{T(0.25), 0, 0}, {T(0.25), 1, 0}, {T(0.25), 0, 1}};
    if (form != BatchForm::one_shape) batch.shapes.push_back(triangle);
    if (form != BatchForm::one_ray)
      batch.rays.push_back({{T(0.25) - (form == BatchForm::one_shape ? shift : 0), T(0.25), -1}, {0, 0, 1}});
  }
  if (form == BatchForm::one_shape) batch.shapes.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  if (form == BatchForm::one_ray) batch.rays.push_back(ray);
  return batch;
}

template <Real T>
Batch<T, Sphere> batch_of_spheres(BatchForm form, std::size_t n, std::size_t offset) {
  Batch<T, Sphere> batch{form, fuzz::FloatMode::nearest, offset, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    // Distances of 0 to 2 from the line against a radius of 1: secants, tangents, misses; some behind.
    const T distance = T(i % 7 % 3), ahead = T(i % 11) - 3;
    if (form != BatchForm::one_shape) batch.shapes.push_back({{distance, 0, ahead}, 1});
    if (form != BatchForm::one_ray) batch.rays.push_back({{form == BatchForm::one_shape ? distance : 0, 0, -1}, {0, 0, 1}});
  }
  if (form == BatchForm::one_shape) batch.shapes.push_back({{0, 0, 0}, 1});
  if (form == BatchForm::one_ray) batch.rays.push_back({{0, 0, -1}, {0, 0, 1}});
  return batch;
}

template <class B>
void require_agreement(const B& batch) {
  if (const auto fault = find_batch_fault(batch)) {
    INFO(*fault);
    REQUIRE(!fault.has_value());
  }
}

TEST_CASE("Batches of every length and alignment answer as the single query") {
  with_each_target([](const std::string& target) {
    CAPTURE(target);
    in_both_formats([]<Real T>() {
      for (const BatchForm form : {BatchForm::one_ray, BatchForm::one_shape, BatchForm::pairs}) {
        for (std::size_t n = 0; n <= 200; ++n) {
          require_agreement(batch_of_triangles<T>(form, n, n % 16));
          require_agreement(batch_of_spheres<T>(form, n, n % 16));
        }
        for (const std::size_t n : {1023, 1024, 1025, 1100, 2111}) {
          require_agreement(batch_of_triangles<T>(form, n, 0));
          require_agreement(batch_of_spheres<T>(form, n, 3));
        }
      }
    });
  });
}

}  // namespace
}  // namespace graze::test
