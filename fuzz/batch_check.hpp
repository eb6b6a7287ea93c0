// Batches held against the single query, lane by lane and bit by bit.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/float_mode.hpp"
#include "fuzz/random.hpp"
#include "graze/types.hpp"

namespace graze::fuzz {

enum class BatchForm { one_ray, one_shape, pairs };

/// A batch of rays against Shape<T>; the side that is one has one element, pairs have as many on both.
template <Real T, template <class> class Shape>
struct Batch {
  BatchForm form = BatchForm::pairs;
  FloatMode mode = FloatMode::nearest;  ///< in which the batch is called
  std::size_t offset = 0;  ///< elements, below 16, by which the arrays are off their alignment, each in its own way
  std::vector<Ray<T>> rays;
  std::vector<Shape<T>> shapes;

  [[nodiscard]] std::size_t lanes() const { return form == BatchForm::one_ray ? shapes.size() : rays.size(); }
};

/// What the batch's `hits`, `intersect` or, for one ray, `nearest` answer otherwise than the single query, or write where they
/// may not, in words; nothing where all agree.
template <Real T, template <class> class Shape>
[[nodiscard]] std::optional<std::string> find_batch_fault(const Batch<T, Shape>& batch);

/// A batch of up to `longest` lanes of the families' cases and of small changes of them: equal shapes, corners in another
/// order, numbers one ulp off; some batches are of one ray and some words of plain shapes, one of them odd.
template <Real T, template <class> class Shape>
[[nodiscard]] Batch<T, Shape> random_batch(Random& random, std::size_t longest);

}  // namespace graze::fuzz
