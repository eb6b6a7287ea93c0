// The kernel's calls for one case held against the truth, bit by bit.
#pragma once

#include <optional>
#include <string>

#include "fuzz/case.hpp"
#include "fuzz/float_mode.hpp"

namespace graze::fuzz {

/// A disagreement, as text.
struct Fault {
  std::string answer, truth;  ///< answer lines with details, the kernel's with what `hits` said
};

/// What `kernel_answer` gets wrong in that mode, if anything.
template <Real T>
[[nodiscard]] std::optional<Fault> find_fault(const Case<T>& input, const Answer<T>& truth, FloatMode mode);

}  // namespace graze::fuzz
