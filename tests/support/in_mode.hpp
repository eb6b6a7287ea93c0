// A function called in each floating-point environment that a caller may have set.
#pragma once

#include <array>
#include <cfenv>
#include <optional>
#include <ostream>
#include <utility>

#include "fuzz/float_mode.hpp"

namespace graze::test {

using fuzz::FloatMode;
using fuzz::FloatModeScope;

/// A rounding mode, with or without flush-to-zero and denormals-are-zero.
struct Environment {
  FloatMode rounding = FloatMode::nearest;
  bool flushes = false;
  bool operator==(const Environment&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const Environment& environment) {
  out << fuzz::name_of(environment.rounding);
  if (environment.flushes) out << " with " << fuzz::name_of(FloatMode::flush);
  return out;
}

inline constexpr std::array rounding_modes{FloatMode::nearest, FloatMode::upward, FloatMode::downward, FloatMode::toward_zero};

inline constexpr std::array environments{Environment{FloatMode::nearest, false},  Environment{FloatMode::upward, false},
                                         Environment{FloatMode::downward, false}, Environment{FloatMode::toward_zero, false},
                                         Environment{FloatMode::nearest, true},   Environment{FloatMode::upward, true},
                                         Environment{FloatMode::downward, true},  Environment{FloatMode::toward_zero, true}};

/// Sets the environment while it lives.
class EnvironmentScope {
 public:
  explicit EnvironmentScope(Environment environment) : rounding_(environment.rounding) {
    if (environment.flushes) flush_.emplace(FloatMode::flush);
  }

 private:
  FloatModeScope rounding_;
  std::optional<FloatModeScope> flush_;
};

#if defined(__SSE2__)
/// Sets the rounding mode of SSE alone, as _MM_SET_ROUNDING_MODE does, while it lives.
class SseRoundingScope {
 public:
  explicit SseRoundingScope(unsigned mode) { _MM_SET_ROUNDING_MODE(mode); }
  ~SseRoundingScope() { _MM_SET_ROUNDING_MODE(before_); }
  SseRoundingScope(const SseRoundingScope&) = delete;
  SseRoundingScope& operator=(const SseRoundingScope&) = delete;

 private:
  unsigned before_ = _MM_GET_ROUNDING_MODE();
};
#endif

/// The rounding mode and, where the machine has them, the bits of flushing and of the traps; not the sticky flags.
struct FloatControl {
  int rounding;
  unsigned long control;
  bool operator==(const FloatControl&) const = default;
};

[[nodiscard]] inline FloatControl float_control() {
#if defined(__SSE2__)
  constexpr unsigned flags = 0x3f;
  return {std::fegetround(), _mm_getcsr() & ~flags};
#elif defined(__aarch64__)
  unsigned long control;
  asm volatile("mrs %0, fpcr" : "=r"(control));
  return {std::fegetround(), control};
#else
  return {std::fegetround(), 0};
#endif
}

/// Calls the function in the environment, and no sooner: the compiler cannot see which function it is, so it cannot move any of
/// it.
template <class Result, class... Params, class... Args>
Result in_mode(Environment environment, Result (*function)(Params...), Args&&... args) {
  Result (*volatile opaque)(Params...) = function;
  const EnvironmentScope scope(environment);
  return opaque(std::forward<Args>(args)...);
}

}  // namespace graze::test
