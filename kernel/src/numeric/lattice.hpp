// Numbers as integers in steps of a lattice that they lie on, where it has few steps: what is computed of those fits in words.
#pragma once

#include <bit>
#include <cstdint>

#include "graze/numeric/filter.hpp"

namespace graze::numeric {

/// What adds to less than `sum` in magnitude adds to less than 2^54 / lattice_fineness = 2^31 steps (kernel/proofs/lattice.g).
inline constexpr double lattice_fineness = 0x1p23;

/// Takes numbers one after another, and tells whether all of them are multiples of one step, a power of two.
///
/// Be size = lattice_fineness * sum and 2^k <= size < 2^(k+1); the step is 2^(k-53) > 2^-54 size. With s = fl(x + size), x is
/// taken if fl(s - size) is x bit for bit, up to the sign of zero. If s >= size / 2, then s and size are multiples of the step,
/// and so is s - size, rounded or not: x is. If s < size / 2, then |x| > size / 2, and x is a multiple of the step itself. This
/// holds in every rounding mode; a subnormal x that denormals-are-zero hides differs in its bits and is not taken.
class Lattice {
 public:
  /// A sum away from underflow and overflow, and not NaN.
  [[nodiscard]] static bool is_possible(double sum) noexcept { return is_ordinary<double, double>(sum, sum); }

  /// Of a sum that is possible.
  explicit Lattice(double sum) noexcept : size_(lattice_fineness * sum) {
    constexpr std::uint64_t exponent_mask = infinity_bits<double>;
    steps_ = std::bit_cast<double>((std::uint64_t(2 * 1023 + 53) << 52) - (bits_of(size_) & exponent_mask));
  }

  void include(double x) noexcept { off_ |= bits_of(x) ^ bits_of((x + size_) - size_); }
  void include(const Vector<double>& v) noexcept { include(v.x), include(v.y), include(v.z); }

  [[nodiscard]] bool holds_all() const noexcept { return (off_ & ~sign_bit<double>) == 0; }

  /// A sum of such numbers that is below 2^53 steps, in steps; without error.
  [[nodiscard]] std::int64_t in_steps(double x) const noexcept { return static_cast<std::int64_t>(x * steps_); }

 private:
  double size_, steps_;
  std::uint64_t off_ = 0;
};

}  // namespace graze::numeric
