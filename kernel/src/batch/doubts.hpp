// Lanes in doubt: gathered until they fill vectors, decided together where they lie on lattices, and one by one elsewhere.
#pragma once

#include <algorithm>
#include <utility>

#include "batch/columns.hpp"
#include "graze/sphere.hpp"
#include "graze/triangle.hpp"
#include "numeric/double_double.hpp"
#include "predicates/in_doubt.hpp"

namespace graze::batch {

/// Of one call. `finish` must be called at the end.
template <class Rays, class Shapes>
class Doubts {
 public:
  Doubts(const Rays& rays, const Shapes& shapes, std::uint64_t* mask) noexcept : rays_(rays), shapes_(shapes), mask_(mask) {}

  /// Lanes of a word of the mask that are in doubt; their bits are not set.
  void add(std::size_t word, std::uint64_t doubt) noexcept {
    if (!is_open_) open();
    if (!is_gathering_) {
      std::uint64_t hit = 0;
      for_each_bit(doubt, [&](std::size_t bit) { hit |= std::uint64_t(decide(64 * word + bit)) << bit; });
      mask_[word] |= hit;
      return;
    }
    words_[word_count_++] = {word, doubt, 0, 0};
    for_each_bit(doubt, [&](std::size_t bit) {
      if constexpr (is_array<Rays>) gather(ray_numbers_, columns(rays_), 64 * word + bit);
      gather(shape_numbers_, columns(shapes_), is_array<Shapes> ? 64 * word + bit : 0);
      ++count_;
    });
    if (count_ >= at_a_time) flush(at_a_time);
  }
  void finish() noexcept {
    if (count_ != 0) flush(count_);
  }

 private:
  static constexpr std::size_t at_a_time = 64, room = 2 * at_a_time;
  static constexpr int shape_columns = decltype(columns(std::declval<const Shapes&>()))::count;

  /// What does not change while the call lasts.
  void open() noexcept {
    is_open_ = true;
    is_gathering_ = !has_range(rays_) && numeric::rounds_to_nearest() && !predicates::flushes_subnormals();
    if constexpr (!is_array<Rays>) gather(ray_numbers_, columns(rays_), 0);
  }

  template <class T, int n, std::size_t m>
  void gather(double (&to)[m][room], const Columns<T, n>& from, std::size_t i) noexcept {
    for (std::size_t k = 0; k < m; ++k) to[k][count_] = from.column[k][i];
  }

  /// Decides the first `count` lanes, at most 64; the others move up.
  void flush(std::size_t count) noexcept {
    Run<double, shape_columns> run{{}, {}, is_array<Rays>, true, false};
    for (int k = 0; k < 6; ++k) run.rays.column[k] = ray_numbers_[k];
    for (int k = 0; k < shape_columns; ++k) run.shapes.column[k] = shape_numbers_[k];
    const std::size_t n = settle_on_lattice(run, count, words_);
    for (std::size_t k = 0; k < n; ++k) {
      const auto& [word, doubt, hits, unknown] = words_[k];
      std::uint64_t hit = hits;
      for_each_bit(unknown, [&, word = word](std::size_t bit) {
        const bool is_hit = decide(64 * word + bit);
        hit |= std::uint64_t(is_hit) << bit;
      });
      mask_[word] |= hit;
    }
    count_ -= count;
    word_count_ = 0;
    if (count_ == 0) return;
    // All that is left is of the last word.
    if constexpr (is_array<Rays>) move_up(ray_numbers_, count);
    move_up(shape_numbers_, count);
    std::uint64_t rest = words_[n - 1].doubt;
    for (auto left = static_cast<std::size_t>(std::popcount(rest)); left > count_; --left) rest &= rest - 1;
    words_[word_count_++] = {words_[n - 1].word, rest, 0, 0};
  }
  template <std::size_t m>
  void move_up(double (&numbers)[m][room], std::size_t from) noexcept {
    for (auto& column : numbers) std::copy_n(column + from, count_, column);
  }

  [[nodiscard]] bool decide(std::size_t i) const noexcept { return graze::hits(lane(rays_, i), lane(shapes_, i)); }

  const Rays& rays_;
  const Shapes& shapes_;
  std::uint64_t* mask_;
  bool is_open_ = false, is_gathering_ = false;
  std::size_t count_ = 0, word_count_ = 0;
  DoubtWord words_[at_a_time + 1];
  alignas(64) double ray_numbers_[6][room], shape_numbers_[shape_columns][room];
};

}  // namespace graze::batch
