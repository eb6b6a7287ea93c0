// The kernels that a command can name.
#pragma once

#include <string>

#include "fuzz/subject.hpp"

namespace graze::cli {

/// The names of the kernels that answer this case, or of all for none; comma-separated.
template <Real T = double>
[[nodiscard]] std::string kernel_names(const fuzz::Case<T>* input = nullptr) {
  std::string names;
  for (const fuzz::Subject* kernel : fuzz::subjects()) {
    if (input != nullptr && !kernel->answer(*input)) continue;
    names.append(names.empty() ? "" : ", ").append(kernel->name());
  }
  return names;
}

}  // namespace graze::cli
