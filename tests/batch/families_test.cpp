// The families' cases in batches, in every floating-point environment and by every instruction set.
#include "fuzz/batch_check.hpp"
#include "fuzz/case.hpp"
#include "tests/batch/targets.hpp"
#include "tests/catch.hpp"
#include "tests/support/family_cases.hpp"
#include "tests/support/formats.hpp"

namespace graze::test {
namespace {

using fuzz::Batch;
using fuzz::BatchForm;

/// All cases of all families as pairs, and each family's first ray or shape against all of the family's others.
template <template <class> class Query, template <class> class Shape, Real T, class ShapeOf>
void require_agreement(std::uint64_t cases_a_family, ShapeOf shape_of) {
  Batch<T, Shape> pairs, default_pairs;
  each_family_query<Query, T>(cases_a_family, [&](const Query<T>& query) {
    pairs.rays.push_back(query.ray);
    pairs.shapes.push_back(shape_of(query));
    default_pairs.rays.push_back({query.ray.origin, query.ray.direction});
    default_pairs.shapes.push_back(shape_of(query));
  });
  CHECK(pairs.rays.size() > 5 * cases_a_family);
  const auto require_in_all_modes = [](Batch<T, Shape>& batch) {
    for (const fuzz::FloatMode mode : fuzz::float_modes) {
      batch.mode = mode;
      if (const auto fault = find_batch_fault(batch)) {
        INFO(*fault);
        REQUIRE(!fault.has_value());
      }
    }
  };
  require_in_all_modes(pairs);
  require_in_all_modes(default_pairs);
  for (std::size_t i = 0; i < pairs.rays.size(); i += cases_a_family / 2) {
    for (const auto* source : {&pairs, &default_pairs}) {
      Batch<T, Shape> one_ray{BatchForm::one_ray, {}, i % 16, {source->rays[i]}, source->shapes};
      Batch<T, Shape> one_shape{BatchForm::one_shape, {}, i % 16, source->rays, {source->shapes[i]}};
      one_ray.mode = one_shape.mode = fuzz::float_modes[i % fuzz::float_modes.size()];
      for (const auto* batch : {&one_ray, &one_shape}) {
        if (const auto fault = find_batch_fault(*batch)) {
          INFO(*fault);
          REQUIRE(!fault.has_value());
        }
      }
    }
  }
}

TEST_CASE("The families in batches: each lane is the single query's, in every mode") {
  with_each_target([](const std::string& target) {
    CAPTURE(target);
    in_both_formats([]<Real T>() {
      require_agreement<fuzz::RayTriangle, Triangle, T>(200, [](const auto& query) { return query.triangle; });
      require_agreement<fuzz::RaySphere, Sphere, T>(200, [](const auto& query) { return query.sphere; });
    });
  });
}

}  // namespace
}  // namespace graze::test
