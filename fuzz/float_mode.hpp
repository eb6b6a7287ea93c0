// The floating-point modes that a caller may have set. For calls of a kernel alone: the oracles want the default one.
#pragma once

#include <array>
#include <cfenv>
#include <optional>
#include <string_view>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace graze::fuzz {

enum class FloatMode {
  nearest,
  upward,
  downward,
  toward_zero,
  flush,  ///< to nearest, with flush-to-zero and denormals-are-zero where the machine has them
};

inline constexpr std::array float_modes{FloatMode::nearest, FloatMode::upward, FloatMode::downward, FloatMode::toward_zero,
                                        FloatMode::flush};

[[nodiscard]] constexpr std::string_view name_of(FloatMode mode) {
  switch (mode) {
    case FloatMode::nearest:
      return "the default rounding mode";
    case FloatMode::upward:
      return "rounding upward";
    case FloatMode::downward:
      return "rounding downward";
    case FloatMode::toward_zero:
      return "rounding toward zero";
    case FloatMode::flush:
      return "flush-to-zero and denormals-are-zero";
  }
  return "unknown";
}

/// As options and reports have it.
[[nodiscard]] constexpr std::string_view word_of(FloatMode mode) {
  constexpr std::array<std::string_view, float_modes.size()> words{"nearest", "up", "down", "zero", "ftz-daz"};
  return words[static_cast<std::size_t>(mode)];
}

/// The mode of that word.
[[nodiscard]] constexpr std::optional<FloatMode> find_float_mode(std::string_view word) {
  for (const FloatMode mode : float_modes) {
    if (word_of(mode) == word) return mode;
  }
  return std::nullopt;
}

/// Sets the mode while it lives. What runs in it must be compiled in another file, or the compiler may move it out.
class FloatModeScope {
 public:
  explicit FloatModeScope(FloatMode mode) {
    std::fegetenv(&before_);
    if (mode == FloatMode::upward) std::fesetround(FE_UPWARD);
    if (mode == FloatMode::downward) std::fesetround(FE_DOWNWARD);
    if (mode == FloatMode::toward_zero) std::fesetround(FE_TOWARDZERO);
    if (mode == FloatMode::flush) set_flush();
  }
  ~FloatModeScope() { std::fesetenv(&before_); }
  FloatModeScope(const FloatModeScope&) = delete;
  FloatModeScope& operator=(const FloatModeScope&) = delete;

 private:
  static void set_flush() {
#if defined(__SSE2__)
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
#elif defined(__aarch64__)
    constexpr unsigned long flush_to_zero = 1UL << 24;
    unsigned long control;
    asm volatile("mrs %0, fpcr" : "=r"(control));
    asm volatile("msr fpcr, %0" : : "r"(control | flush_to_zero));
#endif
  }

  std::fenv_t before_;
};

}  // namespace graze::fuzz
