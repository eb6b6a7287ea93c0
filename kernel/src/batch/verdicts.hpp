// What the lanes are told of a run of queries, and what they tell: plain data between the code of each instruction set and the
// rest.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "graze/types.hpp"

namespace graze::batch {

/// The longest run of lanes that is settled at a time.
inline constexpr std::size_t run_words = 16, run_lanes = 64 * run_words;

/// The lanes of a word that are there, where n are left.
[[nodiscard]] constexpr std::uint64_t present(std::size_t n) noexcept {
  return n < 64 ? (std::uint64_t(1) << n) - 1 : ~std::uint64_t(0);
}

/// Bit i % 64 of word i / 64 for lane i. Bits past the end have no meaning.
struct Verdicts {
  std::uint64_t hit[run_words];    ///< certain
  std::uint64_t doubt[run_words];  ///< neither hit nor miss is certain, or the input may be invalid
  /// Of a certain miss, but not by a ShearedRay: the ray comes from the front (triangles); its origin is inside (spheres).
  std::uint64_t side[run_words];
};

/// Whether any lane of the first `count` is in doubt.
[[nodiscard]] inline bool has_doubt(const Verdicts& verdicts, std::size_t count) noexcept {
  std::uint64_t any = 0;
  for (std::size_t word = 0; 64 * word < count; ++word) any |= verdicts.doubt[word] & present(count - 64 * word);
  return any != 0;
}

/// Calls f(lane) for each bit.
template <class F>
inline void for_each_bit(std::uint64_t bits, F&& f) noexcept {
  for (; bits != 0; bits &= bits - 1) f(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// The numbers of a ray and a shape, as arrays or, where `one`, each a single number.
template <Real T, int n>
struct Columns {
  static constexpr int count = n;
  const T* column[n];
};

/// Origin, direction; t_min and t_max are null for the default range.
template <Real T>
using RayColumns = Columns<T, 8>;
/// Corners a, b, c.
template <Real T>
using TriangleColumns = Columns<T, 9>;
/// Center, radius.
template <Real T>
using SphereColumns = Columns<T, 4>;

/// Some lanes of rays and shapes, each side an array or one.
template <Real T, int shape_columns>
struct Run {
  RayColumns<T> rays;
  Columns<T, shape_columns> shapes;
  bool has_many_rays, has_many_shapes, has_range;
};

/// Said, because clang 14 deduces no aggregate's arguments itself.
template <Real T, int shape_columns>
Run(RayColumns<T>, Columns<T, shape_columns>, bool, bool, bool) -> Run<T, shape_columns>;

template <Real T>
using TriangleRun = Run<T, 9>;
template <Real T>
using SphereRun = Run<T, 4>;

/// A plain ray as sheared_triangles-inl.hpp takes it.
template <Real T>
struct ShearedRay {
  T origin[3];     ///< with the axis of the longest component of the direction last
  T slope[2];      ///< of the direction's first two components on the last
  T least, most;   ///< t_min and t_max times the last component; 0 where they are not asked
  int axis[3];     ///< which axis is first, second, last
  bool backward;   ///< the last component is negative
  bool has_least;  ///< t_min is not 0
  bool has_most;   ///< t_max is not infinite
};

/// A ray without upper end from t = 0, its direction as long as 1, as unit_spheres-inl.hpp takes it: in rounding to nearest.
template <Real T>
struct UnitRay {
  T origin[3], direction[3];
};

/// The verdicts on the lanes first ... first + count - 1, count <= run_lanes, by the best instructions of this processor.
template <Real T>
void settle(const TriangleRun<T>& run, std::size_t first, std::size_t count, Verdicts& out) noexcept;
template <Real T>
void settle(const SphereRun<T>& run, std::size_t first, std::size_t count, Verdicts& out) noexcept;
template <Real T>
void settle(const ShearedRay<T>& ray, const TriangleColumns<T>& triangles, std::size_t first, std::size_t count,
            Verdicts& out) noexcept;
/// A word of the mask and its lanes in doubt, and what is known of them.
struct DoubtWord {
  std::size_t word;
  std::uint64_t doubt;
  std::uint64_t hit, unknown;  ///< of those that were asked of
};
/// The same by exact arithmetic, certain where they lie on lattices, of lanes in doubt that were gathered: their first `count`,
/// at most 64, in the order of the words. Returns how many words these lanes are of. Without range, in rounding to nearest,
/// with subnormal numbers; the shapes are arrays.
std::size_t settle_on_lattice(const TriangleRun<double>& run, std::size_t count, DoubtWord* words) noexcept;
std::size_t settle_on_lattice(const SphereRun<double>& run, std::size_t count, DoubtWord* words) noexcept;

template <Real T>
void settle(const UnitRay<T>& ray, const SphereColumns<T>& spheres, std::size_t first, std::size_t count,
            Verdicts& out) noexcept;
/// The hits among whole words of the mask from lane `first`, which takes less where all lanes are certain. Returns of how many
/// words, from the first, they are; what it writes of the others means nothing.
template <Real T>
[[nodiscard]] std::size_t settle_words(const UnitRay<T>& ray, const SphereColumns<T>& spheres, std::size_t first,
                                       std::size_t words, std::uint64_t* mask) noexcept;

}  // namespace graze::batch
